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

/// The narrowest place of a facet: the radius of the smallest empty ball through its corners, over the
/// largest spacing of these. Infinite for facets with the infinite vertex. The largest spacing, so that
/// facets of a coarse region do not look wide beside a fine one.
double facet_width(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                   const std::vector<double>& spacing, Index t, int k);

}  // namespace filmsticking
