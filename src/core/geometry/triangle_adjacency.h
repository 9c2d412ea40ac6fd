// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vec.h"

namespace filmsticking {

/// Half-edge 3t+k runs from corner k of triangle t to corner k+1.
inline Index next_in_face(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline Index prev_in_face(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

/// What a triangle list is, and what it is not.
struct ManifoldCheck {
  bool indices_valid = true;  ///< corners in range and distinct
  bool edges_simple = true;   ///< no edge has more than two faces
  bool closed = true;         ///< every edge has exactly two
  bool oriented = true;       ///< which traverse it in opposite directions
  bool single_rings = true;   ///< the faces around every vertex form one ring, or one fan at the boundary
  std::int64_t boundary_edges = 0;  ///< edges with one face

  bool manifold() const { return indices_valid && edges_simple && oriented && single_rings; }
  bool ok() const { return manifold() && closed; }  ///< a closed manifold
};

/// twin[h]: the opposite half-edge on the edge of h; kNone unless the edge has exactly these two.
std::vector<Index> half_edge_twins(const std::vector<Corners>& triangles, Index vertex_count);

/// Checks triangles from scratch. Vertices without a face are allowed; a list without faces is not closed.
/// `twins`: receives the half_edge_twins() of an oriented surface, if not null.
ManifoldCheck check_manifold(const std::vector<Corners>& triangles, Index vertex_count,
                             std::vector<Index>* twins = nullptr);

/// The same, faster, for triangles with known twins, which are checked too. Wrong twins count as edges that
/// are not simple.
ManifoldCheck check_manifold_with_twins(const std::vector<Corners>& triangles, Index vertex_count,
                                        const std::vector<Index>& twins);

/// Is there an edge between the origins of two half-edges of a manifold? Takes twice the time of a walk
/// around the origin with fewer faces.
bool have_edge(const std::vector<Corners>& triangles, const std::vector<Index>& twins, Index g, Index k);

/// Flips the edge of half-edge h = ab, which has a twin: its faces abc and bad become dca and cdb, and h runs
/// from d to c. Updates the twins. There must be no edge cd (have_edge()).
void flip_edge(std::vector<Corners>& triangles, std::vector<Index>& twins, Index h);

/// Connected components of a manifold: sets component[t] of every triangle; returns their number.
Index connected_components(const std::vector<Index>& twins, std::vector<Index>& component);

/// The number of boundary loops of a manifold.
std::int64_t boundary_loops(const std::vector<Index>& twins);

/// The topology of triangles. Without twins and components unless they are a manifold.
struct SurfaceTopology {
  ManifoldCheck check;
  std::vector<Index> twin, component;
  Index components = 0;

  SurfaceTopology(const std::vector<Corners>& triangles, Index vertex_count);
};

}  // namespace filmsticking
