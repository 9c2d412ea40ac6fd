// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace filmsticking::io {

/// Unpacks LZF piece by piece, where liblzf and PCL need memory for all of it. Source of the format: liblzf's
/// lzf_d.c (M. A. Lehmann).
class LzfReader {
 public:
  static constexpr std::size_t kMost = 1 << 18;  ///< bytes of a piece

  explicit LzfReader(std::string_view packed) : rest_(packed), buffer_(kWindow + kMost + 2 * kRun) {}

  /// The next `size` bytes, up to kMost; they are valid until the next call. Throws IoError if there are
  /// fewer.
  const char* take(std::size_t size);

  /// Whether all is taken.
  bool at_end() const { return rest_.empty() && begin_ == end_; }

 private:
  void unpack(std::size_t wanted);

  static constexpr std::size_t kWindow = 1 << 13, kRun = 264;  // how far back, and how long a run may be

  std::string_view rest_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // what is unpacked and not taken
};

}  // namespace filmsticking::io
