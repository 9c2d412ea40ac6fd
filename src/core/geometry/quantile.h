// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace filmsticking {

/// The value of rank floor(share * n) among n values in rising order; the largest where that is n. Reorders
/// the range, which must not be empty. `share`: 0 to 1.
template <class Iterator>
auto quantile(Iterator begin, Iterator end, double share) {
  const std::ptrdiff_t count = std::distance(begin, end);
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(count));
  const Iterator at = begin + std::min(rank, count - 1);
  std::nth_element(begin, at, end);
  return *at;
}

/// The middle value; of an even number of values the larger of the two in the middle.
template <class Iterator>
auto median(Iterator begin, Iterator end) {
  return quantile(begin, end, 0.5);
}

}  // namespace filmsticking
