// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/unset_vector.h"
#include "geometry/vec.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// A graph whose nodes have four arcs each: the dual of a tetrahedral mesh.
struct CutGraph {
  /// The arc back along arc k of node t, as 4 * node + arc.
  const UnsetVector<std::array<Index, 4>>& mirror;
  UnsetVector<std::array<std::int32_t, 4>> capacity;  ///< of the arc from node t through k; 0 or more, both
                                                      ///< ways together no more than 2e9
  UnsetVector<std::int64_t> terminal;  ///< > 0: cost of leaving the source's side; < 0: the sink's
};

/// The side of each node in a minimum cut: 1 source, 0 sink. Boykov and Kolmogorov, "An experimental
/// comparison of min-cut/max-flow algorithms" (2004). Nodes that neither tree reaches are on the sink's side
/// unless their `fallback` says otherwise. `capacity` and `terminal` are left as what the flow does not use:
/// with more added to terminals, by their signs, it is the graph of the cut with so much more.
std::vector<char> minimum_cut(CutGraph& graph, const std::vector<char>& fallback, const Cancel& cancel = {});

}  // namespace filmsticking
