// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"

namespace filmsticking {

/// Where one more film step without weights would keep a surface. A facet of it is *stable* if the step keeps
/// the labels of both of its tetrahedra. Returns for each site the share of the facets at it that are stable,
/// from 0 to 1; 1 for a site off the surface. `inside`: per tetrahedron.
std::vector<float> site_stability(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                                  const std::vector<char>& inside);

}  // namespace filmsticking
