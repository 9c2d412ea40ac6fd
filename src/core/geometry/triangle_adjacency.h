// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vec.h"

namespace filmsticking {

/// Half-edge 3t+k runs from corner k of triangle t to corner k+1.
inline Index next_in_face(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline Index prev_in_face(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

/// What is wrong with a triangle list, if anything.
struct ManifoldCheck {
  bool indices_valid = true;  ///< corners in range and distinct
  bool edges_simple = true;   ///< no edge has more than two faces
  bool closed = true;         ///< every edge has exactly two
  bool oriented = true;       ///< which run along it in opposite directions
  bool single_rings = true;   ///< the faces around every vertex form one ring, or one fan at the boundary
  std::int64_t boundary_edges = 0;  ///< edges with one face

  bool manifold() const { return indices_valid && edges_simple && oriented && single_rings; }
  bool ok() const { return manifold() && closed; }  ///< a closed manifold
};

/// twin[h]: the half-edge that runs back along h, or kNone where there is not exactly one.
std::vector<Index> half_edge_twins(const std::vector<Corners>& triangles, Index vertex_count);

/// Vertices without a face are allowed; a list without faces is not closed. `twins`: if wanted, and if it is
/// a manifold, its half_edge_twins().
ManifoldCheck check_manifold(const std::vector<Corners>& triangles, Index vertex_count,
                             std::vector<Index>* twins = nullptr);

/// The same of triangles with known twins, which are checked as well: sooner done. Twins that do not hold are
/// told as edges that are not simple.
ManifoldCheck check_manifold_with_twins(const std::vector<Corners>& triangles, Index vertex_count,
                                        const std::vector<Index>& twins);

/// Is there an edge between the origins of two half-edges of a manifold? Takes no longer than a walk around
/// the one with fewer faces.
bool have_edge(const std::vector<Corners>& triangles, const std::vector<Index>& twins, Index g, Index k);

/// Flips the edge of a half-edge ab with a twin, from between its faces' corners a and b to between their
/// others c and d: abc and bad become dca and cdb, and h runs from d to c. There must be no edge cd.
void flip_edge(std::vector<Corners>& triangles, std::vector<Index>& twins, Index h);

/// Connected components of a manifold: component[t] for every triangle, and their number.
Index connected_components(const std::vector<Index>& twins, std::vector<Index>& component);

/// The number of closed loops of a manifold's edges with one face.
std::int64_t boundary_loops(const std::vector<Index>& twins);

/// How triangles hang together. What is not a manifold has neither twins nor components.
struct SurfaceTopology {
  ManifoldCheck check;
  std::vector<Index> twin, component;
  Index components = 0;

  SurfaceTopology(const std::vector<Corners>& triangles, Index vertex_count);
};

}  // namespace filmsticking
