// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/vec.h"

namespace filmsticking {

/// A set of the numbers below n that is emptied in constant time: searches of stars need millions of them.
class Marks {
 public:
  explicit Marks(std::size_t n) : stamp_(n, 0) {}

  void clear() { ++now_; }
  void add(Index i) { stamp_[i] = now_; }
  bool has(Index i) const { return stamp_[i] == now_; }

 private:
  std::vector<std::uint32_t> stamp_;
  std::uint32_t now_ = 1;
};

}  // namespace filmsticking
