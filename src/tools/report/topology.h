// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "surface.h"

namespace filmsticking::mesh_report {

/// Connectivity of the faces.
struct Topology {
  std::int64_t edges = 0;
  std::int64_t boundary_edges = 0;         ///< with one face
  std::int64_t non_manifold_edges = 0;     ///< with more than two faces
  std::int64_t non_manifold_vertices = 0;  ///< on such an edge, or whose faces are not one ring or fan
  std::int64_t components = 0;             ///< pieces that share no vertex
  bool closed = false;                     ///< there are faces, and no edge has only one
  bool manifold = false;                   ///< there are faces, and all edges and vertices are manifold
  bool oriented = false;  ///< two faces, in opposite directions, at all edges but the boundary
  /// Handles of all components together: components minus half the Euler characteristic. Only for a closed
  /// manifold with two sides.
  std::optional<std::int64_t> genus;
};

Topology topology(const Surface& surface);

}  // namespace filmsticking::mesh_report
