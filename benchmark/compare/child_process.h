// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace filmsticking::bench {

/// Limits of a child; 0: none.
struct Limits {
  double seconds = 0;          ///< wall time; it is killed after that
  std::int64_t memory_mb = 0;  ///< address space, in MB of 10^6 bytes; its allocations fail beyond
};

/// The end of a child and its output.
struct ChildEnd {
  bool timed_out = false;
  int signal = 0;  ///< that ended it; 0: none did
  int code = -1;   ///< exit code, if neither
  std::string out, err;
};

/// Runs a program to its end, in a process group of its own that dies with the calling thread. `threads` > 0
/// is passed to OpenMP. May be called from many threads. Throws std::runtime_error where no process can be
/// made.
ChildEnd run_child(const std::vector<std::string>& command, const Limits& limits, int threads = 0);

}  // namespace filmsticking::bench
