// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"

namespace filmsticking {

/// For each tetrahedron the largest ball that can roll to it from infinity, relative to what the samples it
/// must pass cover: the best way's narrowest facet, measured by its empty circle over the spacing of its
/// corners. Solids that are sampled everywhere have values below two or so; the outside has the width of the
/// mouth that leads there. Widths are told apart between `least` and `most` only and clamped to them, which
/// saves most of the work; infinite tetrahedra have `most`.
std::vector<double> ball_widths(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                                const std::vector<double>& spacing, double least, double most);

}  // namespace filmsticking
