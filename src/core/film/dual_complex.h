// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "film/restricted_power_diagram.h"

namespace filmsticking {

/// Triangles glued along half-edges: 3t, 3t+1, 3t+2 bound triangle t counter-clockwise. Every half-edge has a
/// twin, so the whole is a closed oriented surface; but two edges may join the same sites, and a site may
/// have several rings of triangles (orbits). repair_half_edges() resolves both.
struct HalfEdgeComplex {
  std::vector<Index> site;  ///< at which each half-edge starts
  std::vector<Index> twin;
  std::vector<Vec3> point;  ///< per triangle: the point of the surface where its three cells meet
};

/// The dual of the restricted power diagram (restricted Delaunay triangulation, paper section 4.1): a
/// triangle for every point of the surface where three cells meet.
///
/// Closed by construction: in each face of the surface, the cells that its border runs through form a closed
/// polygon, and the dual of the face is a triangulated disc on that polygon. Its inner triangles are found
/// by gift wrapping, with the geometry deciding which, never whether it closes.
HalfEdgeComplex dual_complex(const Surface& surface, const RestrictedPowerDiagram& restricted,
                             const PowerDiagram& diagram);

}  // namespace filmsticking
