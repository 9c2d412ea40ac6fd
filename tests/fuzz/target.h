// SPDX-License-Identifier: GPL-3.0-or-later
// What the fuzz targets have in common. Each defines LLVMFuzzerTestOneInput(), which libFuzzer or replay.cpp
// calls.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace filmsticking::test {

/// Ends the program at a fault, so that the fuzzer keeps the input; nothing where there is none.
inline void require_no_fault(const std::string& fault) {
  if (fault.empty()) return;
  std::fprintf(stderr, "%s\n", fault.c_str());
  std::abort();
}

/// Takes numbers off the front of an input; zeros once it is used up.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return size_ == 0; }

  template <typename Number>
  Number take() {
    Number number{};
    const std::size_t bytes = std::min(sizeof number, size_);
    if (bytes > 0) std::memcpy(&number, data_, bytes);
    data_ += bytes, size_ -= bytes;
    return number;
  }

  /// 0 to count - 1.
  int below(int count) { return take<std::uint16_t>() % count; }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

}  // namespace filmsticking::test
