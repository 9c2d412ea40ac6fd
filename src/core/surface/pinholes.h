// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/surface.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// Fills the small holes of an open film: closed border lines of at most twelve edges, by the triangulation
/// of their vertices that has the least area (Barequet and Sharir 1995), if no face of it bridges a gap, all
/// of them face the way that the faces around do, and none meets another. The rim of a piece is no hole: what
/// would fill it faces the other way.
///
/// `viewpoint`: what all faces show their fronts to, and those that fill holes as well, or null.
///
/// The manifold stays one, and has the same vertices. The same for any numbering of vertices and faces.
/// `twins`: the film's half_edge_twins() before. Faces that are near each other should have near numbers.
/// Returns how many holes.
std::int64_t fill_pinholes(Surface& film, const std::vector<Index>& twins, const SiteGeometry& geometry,
                           const Vec3* viewpoint = nullptr);

}  // namespace filmsticking
