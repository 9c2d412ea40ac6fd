// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"

namespace filmsticking {

/// Virtual sites (paper, section 4.3): Voronoi vertices near the medial axis, at least twice the local
/// spacing from every site, among the tetrahedra with `wanted` set.
///  - count > 0: at most that many, by farthest-point sampling, the paper's rule;
///  - else by local scale: the empty balls from large to small, each excluding others from half its radius,
///  so
///    that narrow necks get virtual sites too. At most as many as there are sites.
/// `spacing`: per site.
std::vector<Vec3> virtual_sites(const TetrahedralMesh& mesh, const std::vector<double>& spacing, int count,
                                const std::vector<char>& wanted);  // wanted: per tetrahedron

}  // namespace filmsticking
