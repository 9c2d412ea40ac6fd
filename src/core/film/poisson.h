// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"

namespace filmsticking {

/// Poisson reconstruction (paper, section 5, its default; Kazhdan et al. 2006, here CGAL's on adaptive
/// Delaunay tetrahedra) from sites with outward normals: 1 for tetrahedra whose centre is inside, else -1. A
/// zero normal leaves the site out. Empty where the system could not be solved.
std::vector<double> poisson_belief(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                                   const std::vector<Vec3>& normals);

}  // namespace filmsticking
