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
  explicit SignedClusters(std::size_t n) : parent_(n), sign_(n, 1) {
    for (std::size_t i = 0; i < n; ++i) parent_[i] = static_cast<Index>(i);
  }

  /// The root of i's cluster, and i's sign in it. Ends: join() takes roots of two trees, so there are no
  /// rings.
  std::pair<Index, int> find(Index i) {
    Index root = i;
    int sign = 1;
    for (; parent_[root] != root; root = parent_[root]) sign *= sign_[root];
    for (int rest = sign; parent_[i] != i;) {  // the path points at the root from now on
      const Index next = parent_[i];
      const auto own = sign_[i];
      parent_[i] = root, sign_[i] = static_cast<signed char>(rest);
      rest *= own, i = next;
    }
    return {root, sign};
  }

  /// Joins two roots; `a` stays one. `sign`: that of b in a's cluster.
  void join(Index a, Index b, int sign) { parent_[b] = a, sign_[b] = static_cast<signed char>(sign); }

 private:
  std::vector<Index> parent_;
  std::vector<signed char> sign_;
};

}  // namespace filmsticking
