// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "evidence/facet_evidence.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// Inside and outside from local evidence alone. A facet that its corners vote for says that the
/// tetrahedra on its two sides are opposite, one without votes that they are the same; the infinite ones are
/// outside. The least-squares compromise, weighted by the facets' areas, is a linear system with a signed
/// Laplacian (the idea of Kolluri, Shewchuk and O'Brien, "Spectral surface reconstruction from noisy point
/// clouds", 2004, with the outside given instead of an eigenvector), solved by conjugate gradients
/// from a `guess`, one value per tetrahedron.
/// Belief per tetrahedron: about 1 inside, -1 outside, near 0 where the evidence contradicts itself.
std::vector<double> signed_field(const TetrahedralMesh& mesh, const FacetEvidence& evidence,
                                 std::vector<double> guess, const Cancel& cancel = {});

}  // namespace filmsticking
