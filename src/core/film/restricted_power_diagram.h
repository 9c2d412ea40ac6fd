// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "delaunay/power_diagram.h"
#include "geometry/surface.h"

namespace filmsticking {

/// The power cells that the edges of a guiding surface run through: the 1-skeleton of the restricted power
/// diagram (paper, section 4.1). Each edge is cut once, for both of its faces, so that what the faces make
/// of it always fits together, whatever rounding did.
struct RestrictedPowerDiagram {
  std::vector<Index> twin;    ///< of every half-edge of the surface
  std::vector<Index> edge;    ///< per half-edge: its undirected edge
  std::vector<char> forward;  ///< per half-edge: does it run along the edge's direction?
  std::vector<Index> offset;  ///< the cells along edge e: cell[offset[e] .. offset[e+1]), at least one,
  std::vector<Index> cell;    ///< neighbouring ones distinct

  /// Edges along which the walk ended in a cell beside the end's owner, which then follows without being a
  /// neighbour, perhaps: where rounding tells the walk and the search for the owner different sides of a
  /// cell's face. So an edge's end must be within rounding of one, which in clouds that are perturbed is a
  /// chance of 1e-8 or so. The dual is closed all the same.
  std::int64_t jumps = 0;

  /// Neighbours that the walks looked at: for an edge some 20 times as many as there are sites at most, where
  /// all are neighbours and an edge runs through the cells of all, too.
  std::int64_t looks = 0;

  /// Crossing i of edge e, between its cells i and i+1, has this number.
  Index crossing(Index e, Index i) const { return offset[e] + i; }
};

/// Cuts every edge of `surface`, a closed manifold, by the cells of `diagram`, which has at least one.
/// `twin` is half_edge_twins() of the surface.
RestrictedPowerDiagram restrict_power_diagram(const Surface& surface, std::vector<Index> twin,
                                              const PowerDiagram& diagram);

}  // namespace filmsticking
