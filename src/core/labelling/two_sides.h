// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "evidence/facet_evidence.h"
#include "geometry/work_limits.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// [tetrahedron]: 1 inside or -1 outside, from the facets alone. The infinite tetrahedra need not be outside:
/// an open surface has both of its sides there.
///
/// Facets with no votes ask for one side for their two tetrahedra, facets with three votes for two sides. A
/// facet weighs at most the area of one sample, and far less if it is wide; else the facets around the rim of
/// an open surface would outvote it. The two clusters with the strongest sum of weights between them become
/// one, again and again, with the signs that it asks for: greedy additive edge contraction (Keuper et al.,
/// "Efficient decomposition of image and mesh graphs by lifted multicuts", 2015) for two colours. Last, the
/// colour that has more of the hull is outside.
///
/// With full weight, only those facets join their tetrahedra that are on an edge between two facets of the
/// surface, and on no edge with a single one. At a rim the two sides of an open surface meet, and clusters of
/// tetrahedra that grow together there would mix them.
///
/// `viewpoint`: a point to which all of the surface shows the same side, or null. It joins clusters that
/// little else joins. Throws Cancelled.
std::vector<double> two_sides(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                              const FacetEvidence& evidence, const SiteGeometry& geometry,
                              const Vec3* viewpoint = nullptr, const Cancel& cancel = {});

}  // namespace filmsticking
