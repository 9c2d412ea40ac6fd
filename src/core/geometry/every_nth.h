// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace filmsticking {

/// A regular sample of the indices below `count`, at most `most` of them: 0, n, 2n, ..., where n is
/// count / most + 1.
class EveryNth {
 public:
  /// `most`: at least one.
  EveryNth(std::size_t count, std::size_t most)
      : step_(count / most + 1), size_((count + step_ - 1) / step_) {}

  std::size_t size() const { return size_; }
  std::size_t operator[](std::size_t i) const { return i * step_; }

 private:
  std::size_t step_, size_;
};

}  // namespace filmsticking
