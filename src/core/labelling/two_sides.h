// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "evidence/facet_evidence.h"
#include "geometry/work_limits.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// Where a facet stands on the surface: on an edge between two facets that at least so many corners vote for,
/// and on none with one such facet. And how much it counts where it does not, of what it does there. There is
/// a way around a rim, and clusters of tetrahedra that first meet there would be joined across it.
struct RimRule {
  int votes;
  double weight;
};

/// Which side of the surface each tetrahedron is on, 1 inside or -1 outside, from the facets alone and
/// without taking the infinite tetrahedra to be outside: an open surface has both of its sides there.
///
/// A facet says that its tetrahedra are on one side (no votes) or on two (three votes), with a weight of at
/// most the area of one sample and far less for wide facets, so that those around the rim of an open surface
/// do not outvote the surface; "one side" counts where the facet stands on the surface, and little in the air
/// and at the rim (RimRule). The two clusters with the
/// strongest sum of such evidence between them become one, again and again, with the signs that it asks for:
/// greedy additive edge contraction (Keuper et al. 2015) for two colours. At last the colour that has more of
/// the hull is outside.
///
/// `viewpoint`: a point to which all of the surface shows the same side, or null. What facets say of that
/// joins clusters that little else joins.
std::vector<double> two_sides(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                              const FacetEvidence& evidence, const SiteGeometry& geometry, const RimRule& rim,
                              const Vec3* viewpoint = nullptr, const Cancel& cancel = {});

}  // namespace filmsticking
