// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "evidence/facet_evidence.h"
#include "geometry/work_limits.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// Inside and outside from local evidence alone. Returns a belief per tetrahedron: about 1 inside, -1
/// outside, near 0 where the evidence contradicts itself.
///
/// A facet with two or three votes pulls the tetrahedra on its two sides to opposite beliefs, a facet with
/// one or none to equal beliefs, by kVoteCoupling. Infinite tetrahedra are outside. The least-squares
/// compromise, weighted by the facets' areas, up to kMostSamples samples each, is a linear system with a
/// signed Laplacian (after Kolluri, Shewchuk and O'Brien, "Spectral surface reconstruction from noisy point
/// clouds", 2004, with the outside given instead of an eigenvector). Conjugate gradients solve it from
/// `guess`, one value per tetrahedron. `known`: empty, or a pull per tetrahedron in units of area: > 0 to the
/// inside, < 0 to the outside. Throws Cancelled.
std::vector<double> signed_field(const TetrahedralMesh& mesh, const FacetEvidence& evidence,
                                 const SiteGeometry& geometry, std::vector<double> guess,
                                 const std::vector<double>& known = {}, const Cancel& cancel = {});

}  // namespace filmsticking
