// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// Numbers the pieces of the inside and the outside, connected through facets, by their least tetrahedra into
/// `piece`[tetrahedron]. Returns how many there are.
Index label_pieces(const TetrahedralMesh& mesh, const std::vector<char>& inside, std::vector<Index>& piece);

/// Gives islands the label around them: pieces most of whose sites have their nearest sites on the surfaces
/// of other pieces. Such a piece is torn from a surface that continues beside it; a part of its own has sites
/// that are near each other. Returns how many pieces changed labels.
///
/// Only whole pieces do, so that a surface that was a manifold stays one.
std::int64_t drop_islands(const TetrahedralMesh& mesh, const SiteGeometry& geometry,
                          std::vector<char>& inside);

}  // namespace filmsticking
