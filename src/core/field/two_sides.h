// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "facet_evidence.h"
#include "site_geometry.h"
#include "tetrahedral_mesh.h"
#include "work_limits.h"

namespace filmsticking {

/// Which side of the surface each tetrahedron is on, 1 inside or -1 outside, from the facets alone and
/// without taking the infinite tetrahedra to be outside: an open surface has both of its sides there.
///
/// A facet says that its tetrahedra are on one side (no votes) or on two (three votes), with a weight of at
/// most the area of one sample and far less for wide facets, so that those around the rim of an open surface
/// do not outvote the surface; "one side" counts where the facet stands on the surface, between two facets
/// that all corners vote for, and `at_rim` of that in the air and at the rim. The two clusters with the
/// strongest sum of such evidence between them become one, again and again, with the signs that it asks for:
/// greedy additive edge contraction (Keuper et al. 2015) for two colours. At last the colour that has more of
/// the hull is outside.
std::vector<double> two_sides(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                              const FacetEvidence& evidence, const SiteGeometry& geometry, double at_rim,
                              const Cancel& cancel = {});

}  // namespace filmsticking
