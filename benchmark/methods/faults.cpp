// SPDX-License-Identifier: GPL-3.0-or-later
#include "faults.h"

#include <csignal>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <thread>

namespace filmsticking::bench {

Outcome run_fault_crash(const std::vector<Point>&, int) {
  std::raise(SIGSEGV);
  return {};
}

Outcome run_fault_hang(const std::vector<Point>&, int) {
  for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

Outcome run_fault_throw(const std::vector<Point>&, int) { throw std::runtime_error("thrown, on purpose"); }

Outcome run_fault_memory(const std::vector<Point>&, int) {
  constexpr std::size_t kBlock = std::size_t{64} << 20, kMostBlocks = 64;  // 4 GB: no machine must suffer
  std::vector<std::unique_ptr<char[]>> blocks;
  while (blocks.size() < kMostBlocks) {
    blocks.push_back(std::make_unique<char[]>(kBlock));
    std::memset(blocks.back().get(), static_cast<int>(blocks.size()), kBlock);
  }
  throw std::runtime_error("there was no memory limit");
}

}  // namespace filmsticking::bench
