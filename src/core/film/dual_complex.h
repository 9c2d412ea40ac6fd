// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "film/restricted_power_diagram.h"

namespace filmsticking {

/// Triangles glued along half-edges. Half-edges 3t, 3t+1, 3t+2 bound triangle t counter-clockwise. Every
/// half-edge has a twin, so the complex is a closed oriented surface. Two edges may join the same sites, and
/// a site may have several rings of triangles (orbits). repair_half_edges() resolves both.
struct HalfEdgeComplex {
  std::vector<Index> site;  ///< per half-edge: the site where it starts
  std::vector<Index> twin;
  std::vector<Vec3> point;  ///< per triangle: the point of the surface where its three cells meet
};

/// The dual of the restricted power diagram (restricted Delaunay triangulation, paper section 4.1): a
/// triangle for every point of the surface where three cells meet.
///
/// Closed by construction: the cells along the border of each face form a closed polygon, and the face's dual
/// is a triangulated disc on that polygon. Gift wrapping finds its triangles. Geometry decides which
/// triangles, never whether they close.
HalfEdgeComplex dual_complex(const Surface& surface, const RestrictedPowerDiagram& restricted,
                             const PowerDiagram& diagram);

}  // namespace filmsticking
