// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace filmsticking::bench {

/// Wall time in seconds since it was made or last read.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - begin_).count();
    begin_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace filmsticking::bench
