// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "evidence/facet_evidence.h"
#include "geometry/work_limits.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// What the lines from sites to their sensors say of the tetrahedra.
struct Sight {
  /// [tetrahedron], in lines: > 0, so many end just before it, which makes it inside; < 0, so many pass
  /// through it, which makes it outside. Empty: nothing is known.
  std::vector<float> votes;
  std::int64_t lines = 0;    ///< sites whose sensor is known
  std::int64_t leaving = 0;  ///< lines that leave the hull: to sensors outside
  std::int64_t blocked = 0;  ///< lines through a facet that all of its corners vote for
};

/// Walks from every site to its viewpoint through the tetrahedra, and half a spacing beyond the site (after
/// Labatut, Pons and Keriven, "Robust and efficient surface reconstruction from range data", 2009). Near its
/// site a line counts less, as sites are off the surface by noise; a short way through a tetrahedron counts
/// less than one spacing does. A walk ends at the hull, however far the sensor is.
///
/// `viewpoints`: one per site, in the frame of the sites; not finite: unknown. Linear in the tetrahedra that
/// are crossed. The votes do not depend on the number of threads. Throws Cancelled.
Sight lines_of_sight(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                     const SiteGeometry& geometry, const FacetEvidence& evidence,
                     const std::vector<Vec3>& viewpoints, const Cancel& cancel = {});

}  // namespace filmsticking
