// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as bytes of files, and the output of these bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#error "this file assumes a little-endian machine"
#endif

namespace filmsticking::io {

/// The number types of files; their values are those of pcl::PCLPointField::datatype.
enum class Scalar : std::uint8_t {
  Int8 = 1,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float,
  Double,
  Int64,
  UInt64
};

/// Bytes of a number; 0 for a type that is none of Scalar.
inline std::size_t size_of(Scalar type) {
  constexpr std::uint8_t kSizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8, 8, 8};
  const auto index = static_cast<std::size_t>(type);
  return index < sizeof kSizes ? kSizes[index] : 0;
}

/// The little-endian number at `bytes`, which may be any place.
template <typename T, typename Byte>
T load(const Byte* bytes) {
  static_assert(sizeof(Byte) == 1);
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// The number of the same bits.
template <typename T, typename Bits>
T as(Bits bits) {
  static_assert(sizeof(T) == sizeof bits);
  T value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// The big-endian number at `bytes`, which may be any place.
template <typename T, typename Byte>
T load_big(const Byte* bytes) {
  if constexpr (sizeof(T) == 1) {
    return load<T>(bytes);
  } else if constexpr (sizeof(T) == 2) {
    return as<T>(__builtin_bswap16(load<std::uint16_t>(bytes)));
  } else if constexpr (sizeof(T) == 4) {
    return as<T>(__builtin_bswap32(load<std::uint32_t>(bytes)));
  } else {
    return as<T>(std::uint64_t{__builtin_bswap64(load<std::uint64_t>(bytes))});
  }
}

/// The little-endian number of this type at `bytes`, rounded to double precision.
double load(const void* bytes, Scalar type);

/// Puts the text of a number to `to` as its type's bytes. False if it is no number or its type cannot hold
/// it, as a fraction where it is whole.
bool store_number(std::string_view text, Scalar type, void* to);

/// Appends the number's little-endian bytes.
template <typename T>
void append(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

/// Receives the bytes of a file, piece by piece. Throws IoError.
using ByteSink = std::function<void(std::string_view)>;

/// Collects what an encoder appends and passes on full pieces, so that a file is never whole in memory.
class ByteWriter {
 public:
  explicit ByteWriter(ByteSink sink) : sink_(std::move(sink)) {}

  /// Appends by `add(std::string& bytes)`: a point or a triangle, say.
  template <typename Add>
  void add(Add add) {
    add(piece_);
    if (piece_.size() >= kPiece) flush();
  }
  void append(std::string_view bytes) {
    add([&](std::string& piece) { piece += bytes; });
  }

  /// Passes the rest on.
  void flush() {
    sink_(piece_);
    piece_.clear();
  }

 private:
  static constexpr std::size_t kPiece = 1 << 16;

  ByteSink sink_;
  std::string piece_;
};

}  // namespace filmsticking::io
