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
  if (end_ - begin_ < size && begin_ > kWindow) {
    const std::size_t first = begin_ - kWindow;  // copies may reach there
    std::memmove(buffer_.data(), buffer_.data() + first, end_ - first);
    begin_ -= first, end_ -= first;
  }
  while (end_ - begin_ < size) unpack_run();
  const char* const piece = buffer_.data() + begin_;
  begin_ += size;
  return piece;
}

/// Bytes as they are, or a copy of earlier ones.
void LzfReader::unpack_run() {
  const auto next = [&] {
    if (rest_.empty()) throw_broken();
    const auto byte = static_cast<unsigned char>(rest_[0]);
    rest_.remove_prefix(1);
    return std::size_t{byte};
  };
  constexpr std::size_t kLiterals = 32, kLong = 7;
  const std::size_t control = next();
  if (control < kLiterals) {
    if (control + 1 > rest_.size()) throw_broken();
    std::memcpy(buffer_.data() + end_, rest_.data(), control + 1);
    rest_.remove_prefix(control + 1);
    end_ += control + 1;
    return;
  }
  std::size_t length = control / kLiterals;
  if (length == kLong) length += next();
  length += 2;
  const std::size_t back = (control % kLiterals) * 256 + next() + 1;
  if (back > end_) throw_broken();
  char* const to = buffer_.data() + end_;
  if (back >= length) {
    std::memcpy(to, to - back, length);
  } else {
    for (std::size_t k = 0; k < length; ++k) to[k] = to[k - back];  // it repeats itself
  }
  end_ += length;
}

}  // namespace filmsticking::io
