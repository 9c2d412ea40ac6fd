// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"

namespace filmsticking {

/// For each tetrahedron the radius of the largest ball that can roll there from infinity, in spacings: the
/// widest path's narrowest facet, measured by its empty ball over the largest spacing of its corners. Inside
/// a densely sampled solid the width is below about two. Outside it is the width of the opening that leads
/// there.
///
/// Widths are clamped to [least, most], which saves most of the work. Infinite tetrahedra have `most`.
/// `spacing`: per site, as in SiteGeometry.
std::vector<double> ball_widths(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                                const std::vector<double>& spacing, double least, double most);

}  // namespace filmsticking
