// SPDX-License-Identifier: GPL-3.0-or-later
#include "lzf.h"

#include <algorithm>
#include <cstring>

#include "io_error.h"

namespace filmsticking::io {
namespace {

[[noreturn]] void throw_broken() { throw IoError("its compressed data are broken"); }

}  // namespace

const char* LzfReader::take(std::size_t size) {
  if (end_ - begin_ < size) {
    if (begin_ > kWindow) {
      const std::size_t first = begin_ - kWindow;  // copies may reach there
      std::memmove(buffer_.data(), buffer_.data() + first, end_ - first);
      begin_ -= first, end_ -= first;
    }
    unpack(begin_ + size);
  }
  const char* const piece = buffer_.data() + begin_;
  begin_ += size;
  return piece;
}

/// Runs of bytes as they are, and copies of earlier ones, until `end_` is at least `wanted`.
void LzfReader::unpack(std::size_t wanted) {
  constexpr std::size_t kLiterals = 32, kLong = 7;
  const auto* from = reinterpret_cast<const unsigned char*>(rest_.data());
  const auto* const last = from + rest_.size();
  char* const begin = buffer_.data();
  char* to = begin + end_;
  while (to < begin + wanted) {
    if (from == last) throw_broken();
    const std::size_t control = *from++;
    if (control < kLiterals) {
      const std::size_t length = control + 1;
      const auto left = static_cast<std::size_t>(last - from);
      if (length > left) throw_broken();
      std::memcpy(to, from, left < kLiterals ? length : kLiterals);  // a fixed length is faster
      from += length, to += length;
      continue;
    }
    std::size_t length = control / kLiterals;
    if (last - from < (length == kLong ? 2 : 1)) throw_broken();
    if (length == kLong) length += *from++;
    length += 2;
    const std::size_t back = (control % kLiterals) * 256 + *from++ + 1;
    if (back > static_cast<std::size_t>(to - begin)) throw_broken();
    if (back >= length) {
      std::memcpy(to, to - back, length);
    } else {
      for (std::size_t k = 0; k < length; ++k) to[k] = *(to + k - back);  // it repeats itself
    }
    to += length;
  }
  rest_.remove_prefix(static_cast<std::size_t>(reinterpret_cast<const char*>(from) - rest_.data()));
  end_ = static_cast<std::size_t>(to - begin);
}

}  // namespace filmsticking::io
