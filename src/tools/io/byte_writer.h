// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace filmsticking::io {

/// Where the bytes of a file go, piece by piece. Throws IoError.
using ByteSink = std::function<void(std::string_view)>;

/// What an encoder appends to. Passes on full pieces, so that a file is never whole in memory.
class ByteWriter {
 public:
  explicit ByteWriter(ByteSink sink) : sink_(std::move(sink)) {}

  /// Appends by `add(std::string& bytes)`: a point, a triangle or what else is small.
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
