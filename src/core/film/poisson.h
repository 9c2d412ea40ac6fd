// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"

namespace filmsticking {

/// Inside and outside by Poisson reconstruction (paper, section 5, its default; Kazhdan et al. 2006), by
/// CGAL's on adaptive Delaunay tetrahedra. Returns per tetrahedron 1 if its centroid is inside, else -1;
/// empty if the system cannot be solved. `normals`: outward, per site, of any length; zero leaves the site
/// out.
std::vector<double> poisson_belief(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                                   const std::vector<Vec3>& normals);

}  // namespace filmsticking
