// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/vec.h"

namespace filmsticking {

/// Disjoint clusters of the numbers below n, in which each has a sign relative to the cluster's root.
class SignedClusters {
 public:
  explicit SignedClusters(std::size_t n) : parent_(n) {
    for (std::size_t i = 0; i < n; ++i) parent_[i] = {static_cast<Index>(i), 1};
  }

  /// The root of i's cluster, and i's sign in it. Ends: join() takes roots of two trees, so there are no
  /// rings.
  std::pair<Index, int> find(Index i) {
    Index root = i;
    int sign = 1;
    for (; parent_[root].first != root; root = parent_[root].first) sign *= parent_[root].second;
    for (int rest = sign; parent_[i].first != root;) {  // the path points at the root from now on
      const auto [next, own] = parent_[i];
      parent_[i] = {root, rest};
      rest *= own, i = next;
    }
    return {root, sign};
  }

  /// Joins two roots; `a` stays one. `sign`: that of b in a's cluster.
  void join(Index a, Index b, int sign) { parent_[b] = {a, sign}; }

 private:
  std::vector<std::pair<Index, int>> parent_;  // with the sign in its cluster
};

}  // namespace filmsticking
