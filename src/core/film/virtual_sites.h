// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"

namespace filmsticking {

/// Virtual sites from the Voronoi vertices near the medial axis (paper, section 4.3) where no site is
/// within twice the local spacing, of the balls for which `wanted` is set.
///  - count > 0: that many, by farthest-point sampling: the paper's rule;
///  - otherwise by local scale: the empty balls from large to small, each keeping others out of half its
///    radius, so that narrow necks get theirs too; at most as many as there are sites.
std::vector<Vec3> virtual_sites(const TetrahedralMesh& mesh, const std::vector<double>& spacing, int count,
                                const std::vector<char>& wanted);  // per tetrahedron

}  // namespace filmsticking
