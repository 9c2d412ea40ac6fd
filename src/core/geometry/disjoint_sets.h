// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <utility>
#include <vector>

#include "geometry/parallel.h"
#include "geometry/vec.h"

namespace filmsticking {

/// Disjoint sets of the numbers below n, which several threads may unite at once (Anderson and Woll,
/// "Wait-free parallel algorithms for the union-find problem", 1991). The least member names a set. Links
/// lead to lesser members, and a root is linked once.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : link_(n) {
    parallel_each(n,
                  [&](std::size_t i) { link_[i].store(static_cast<Index>(i), std::memory_order_relaxed); });
  }

  /// The least member of i's set. Ends: every step goes to a lesser member.
  Index find(Index i) {
    for (Index up = link(i); up != i; up = link(i)) {
      const Index above = link(up);
      if (above != up) link_[i].compare_exchange_weak(up, above, std::memory_order_relaxed);
      i = above;
    }
    return i;
  }

  void unite(Index a, Index b) {
    for (;;) {  // ends: each failure means that another thread linked a root
      a = find(a), b = find(b);
      if (a == b) return;
      if (a < b) std::swap(a, b);
      Index expected = a;
      if (link_[a].compare_exchange_strong(expected, b, std::memory_order_relaxed)) return;
    }
  }

  /// set[i]: the number of i's set, in the order of least members. Returns the number of sets. Not while
  /// other threads unite.
  Index number(std::vector<Index>& set) {
    set.resize(link_.size());
    parallel_each(set.size(), [&](std::size_t i) { set[i] = find(static_cast<Index>(i)); });
    std::vector<Index> least;
    for (std::size_t i = 0; i < set.size(); ++i)
      if (set[i] == static_cast<Index>(i)) least.push_back(set[i]);
    parallel_each(set.size(), [&](std::size_t i) {
      set[i] = static_cast<Index>(std::lower_bound(least.begin(), least.end(), set[i]) - least.begin());
    });
    return static_cast<Index>(least.size());
  }

 private:
  Index link(Index i) const { return link_[i].load(std::memory_order_relaxed); }

  std::vector<std::atomic<Index>> link_;
};

}  // namespace filmsticking
