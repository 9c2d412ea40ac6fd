// SPDX-License-Identifier: GPL-3.0-or-later
#include "bytes.h"

#include <cmath>
#include <limits>

#include "text_scanner.h"

namespace filmsticking::io {
namespace {

template <typename T>
bool store(T value, void* to) {
  std::memcpy(to, &value, sizeof value);
  return true;
}

/// `Other` has the same size: colours packed into 32 bits are written with or without sign.
template <typename T, typename Other = T>
bool store_whole(std::string_view text, void* to) {
  double value = 0;
  if (!parse_number(text, value) || value != std::floor(value)) return false;
  if (value >= double{std::numeric_limits<T>::min()} && value <= double{std::numeric_limits<T>::max()})
    return store(static_cast<T>(value), to);
  return value >= double{std::numeric_limits<Other>::min()} &&
         value <= double{std::numeric_limits<Other>::max()} && store(static_cast<Other>(value), to);
}

/// All digits of 64 bits, which double precision would round.
template <typename T>
bool store_long(std::string_view text, void* to) {
  T value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && store(value, to);
}

template <typename T>
bool store_real(std::string_view text, void* to) {
  T value = 0;
  return parse_number(text, value) && store(value, to);
}

}  // namespace

double load(const void* bytes, Scalar type) {
  const auto* from = static_cast<const char*>(bytes);
  switch (type) {
    case Scalar::Int8:
      return load<std::int8_t>(from);
    case Scalar::UInt8:
      return load<std::uint8_t>(from);
    case Scalar::Int16:
      return load<std::int16_t>(from);
    case Scalar::UInt16:
      return load<std::uint16_t>(from);
    case Scalar::Int32:
      return load<std::int32_t>(from);
    case Scalar::UInt32:
      return load<std::uint32_t>(from);
    case Scalar::Int64:
      return static_cast<double>(load<std::int64_t>(from));
    case Scalar::UInt64:
      return static_cast<double>(load<std::uint64_t>(from));
    case Scalar::Float:
      return static_cast<double>(load<float>(from));
    case Scalar::Double:
      return load<double>(from);
  }
  return 0;
}

bool store_number(std::string_view text, Scalar type, void* to) {
  switch (type) {
    case Scalar::Int8:
      return store_whole<std::int8_t>(text, to);
    case Scalar::UInt8:
      return store_whole<std::uint8_t>(text, to);
    case Scalar::Int16:
      return store_whole<std::int16_t>(text, to);
    case Scalar::UInt16:
      return store_whole<std::uint16_t>(text, to);
    case Scalar::Int32:
      return store_whole<std::int32_t, std::uint32_t>(text, to);
    case Scalar::UInt32:
      return store_whole<std::uint32_t, std::int32_t>(text, to);
    case Scalar::Int64:
      return store_long<std::int64_t>(text, to);
    case Scalar::UInt64:
      return store_long<std::uint64_t>(text, to);
    case Scalar::Float:
      return store_real<float>(text, to);
    case Scalar::Double:
      return store_real<double>(text, to);
  }
  return false;
}

}  // namespace filmsticking::io
