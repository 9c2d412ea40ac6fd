// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"

namespace filmsticking {

/// The cavities that a film does not reach, as behind a narrow mouth or in a hollow shell. A *room* is a part
/// of the inside whose tetrahedra are joined by facets at least kRoomWidth wide (facet_width(), in spacings).
/// A room is a cavity if most of its sites are off the film: a solid's room ends at the sites that the film
/// is on, a cavity's at sites behind a wall. Weights (paper, section 4.2) would pull those through the wall.
///
/// `inside`, [tetrahedron], and `sides`, [site] as from site_sides(), describe the film. Returns 1 for each
/// tetrahedron of a cavity. A film without these is closed as well.
std::vector<char> cavities(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                           const std::vector<double>& spacing, const std::vector<char>& inside,
                           const std::vector<char>& sides);

/// In spacings: the width below which no virtual site fits (virtual_sites.h).
constexpr double kRoomWidth = 2;

}  // namespace filmsticking
