// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/unset_vector.h"
#include "geometry/vec.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// A graph whose nodes have four arcs each: the dual graph of a tetrahedral mesh.
struct CutGraph {
  /// The arc back along arc k of node t, as 4 * node + arc.
  const UnsetVector<std::array<Index, 4>>& mirror;
  /// Of the arc from node t through k: 0 or more, and with the arc back at most 2e9.
  UnsetVector<std::array<std::int32_t, 4>> capacity;
  /// [t]: > 0: the cost of t on the sink's side; < 0: its negative, of t on the source's side.
  UnsetVector<std::int64_t> terminal;
};

/// The side of each node in a minimum cut: 1 source, 0 sink. A node that no side reaches takes its
/// `fallback`. The algorithm is that of Boykov and Kolmogorov, "An experimental comparison of
/// min-cut/max-flow algorithms" (2004); ours and not Boost's, as it restarts from the last flow and takes
/// some 40 bytes a node.
///
/// Leaves in `capacity` and `terminal` what the flow does not use. With more added to terminals, by their
/// signs, that is a graph whose cuts are those of the whole graph with so much more. Throws Cancelled.
std::vector<char> minimum_cut(CutGraph& graph, const std::vector<char>& fallback, const Cancel& cancel = {});

}  // namespace filmsticking
