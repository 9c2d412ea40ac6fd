// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "delaunay/power_diagram.h"
#include "geometry/surface.h"

namespace filmsticking {

/// The power cells along the edges of a film: the 1-skeleton of the restricted power diagram (paper, section
/// 4.1). Each edge is divided once for both of its faces, so the faces agree whatever rounding does.
struct RestrictedPowerDiagram {
  std::vector<Index> twin;    ///< per half-edge of the surface
  std::vector<Index> edge;    ///< per half-edge: its undirected edge
  std::vector<char> forward;  ///< per half-edge: whether it has the edge's direction
  std::vector<Index> offset;  ///< cells along edge e: cell[offset[e] .. offset[e+1]), at least one
  std::vector<Index> cell;    ///< consecutive cells of an edge are distinct

  /// Edges whose walk ended in another cell than the owner of the edge's end, which was appended, perhaps
  /// without being a neighbour. Happens if the end is within rounding of a cell's face: a chance of about
  /// 1e-8 for perturbed sites. The dual is closed all the same.
  std::int64_t jumps = 0;

  /// Neighbours visited by the walks. For an edge at most about 20 times the number of sites, even if all
  /// sites are neighbours and the edge crosses all cells.
  std::int64_t looks = 0;

  /// The number of the crossing between cells i and i+1 of edge e.
  Index crossing(Index e, Index i) const { return offset[e] + i; }
};

/// Divides every edge of `surface`, a closed manifold, by the cells of `diagram`, which has at least one
/// cell. `twin`: half_edge_twins() of the surface.
RestrictedPowerDiagram restrict_power_diagram(const Surface& surface, std::vector<Index> twin,
                                              const PowerDiagram& diagram);

}  // namespace filmsticking
