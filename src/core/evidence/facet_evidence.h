// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "delaunay/tetrahedral_mesh.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// What a facet says of its two sides, by votes: 1 the same, -1 opposite.
constexpr double kVoteCoupling[4] = {1.0, 0.3, -0.3, -1.0};

/// What is known of each facet from the sites alone. Index [t][k]: the facet of tetrahedron t opposite its
/// corner k, the same from both sides; facets with the infinite vertex have zeros.
struct FacetEvidence {
  UnsetVector<std::array<float, 4>> area;
  /// 0 to 3: a corner votes for the facet if the facet's dual Voronoi edge crosses the corner's tangent plane
  /// within two spacings of it, that is, if the facet belongs to the corner's own local triangulation (the
  /// idea of Co3Ne, Boltcheva and Levy 2017, on the Delaunay facets).
  UnsetVector<std::array<signed char, 4>> votes;
  /// What it costs to have the facet on the surface: area x (a price by votes + a price for empty balls that
  /// do not lie flat on it, Labatut et al. 2009).
  UnsetVector<std::array<float, 4>> cost;
};

FacetEvidence facet_evidence(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                             const SiteGeometry& geometry);

}  // namespace filmsticking
