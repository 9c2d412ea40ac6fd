// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#error "this file takes the machine for a little-endian one"
#endif

namespace filmsticking::io {

/// The number types of binary files.
enum class Scalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float, Double };

inline std::size_t size_of(Scalar type) {
  switch (type) {
    case Scalar::Int8:
    case Scalar::UInt8:
      return 1;
    case Scalar::Int16:
    case Scalar::UInt16:
      return 2;
    case Scalar::Int64:
    case Scalar::UInt64:
    case Scalar::Double:
      return 8;
    default:
      return 4;
  }
}

/// The little-endian number at `bytes`.
template <typename T>
T load(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

inline double load(const char* bytes, Scalar type) {
  switch (type) {
    case Scalar::Int8:
      return load<std::int8_t>(bytes);
    case Scalar::UInt8:
      return load<std::uint8_t>(bytes);
    case Scalar::Int16:
      return load<std::int16_t>(bytes);
    case Scalar::UInt16:
      return load<std::uint16_t>(bytes);
    case Scalar::Int32:
      return load<std::int32_t>(bytes);
    case Scalar::UInt32:
      return load<std::uint32_t>(bytes);
    case Scalar::Int64:
      return static_cast<double>(load<std::int64_t>(bytes));
    case Scalar::UInt64:
      return static_cast<double>(load<std::uint64_t>(bytes));
    case Scalar::Float:
      return static_cast<double>(load<float>(bytes));
    case Scalar::Double:
      return load<double>(bytes);
  }
  return 0;
}

/// Appends the number's little-endian bytes.
template <typename T>
void append(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

}  // namespace filmsticking::io
