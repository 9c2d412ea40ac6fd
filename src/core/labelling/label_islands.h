// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// The pieces of the inside and the outside, connected through facets, numbered by their least tetrahedra in
/// `piece`[tetrahedron]. Returns how many there are.
Index label_pieces(const TetrahedralMesh& mesh, const std::vector<char>& inside, std::vector<Index>& piece);

/// Gives up islands: pieces of the inside or the outside, connected through facets, most of whose sites have
/// their nearest sites on the surfaces of other pieces. Such a piece is torn from a surface that goes on
/// beside it; the sites of a part of its own have each other. Returns how many pieces changed sides.
///
/// Only whole pieces change sides, so that a surface that was a manifold stays one.
std::int64_t drop_islands(const TetrahedralMesh& mesh, const SiteGeometry& geometry,
                          std::vector<char>& inside);

}  // namespace filmsticking
