// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Removes sliver faces of a surface of sites: faces with a corner on the opposite edge, as near as
/// coordinates are rounded. Collinear points, as in rows of a depth image, leave them. A sliver has no area,
/// so the surface is the same without it. The edge is flipped; at the boundary the sliver is removed.
///
/// The surface stays a manifold and keeps all its vertices; slivers that prevent this stay. Independent of
/// the numbering of vertices and faces. `twins`: the half_edge_twins() before. Returns the number removed.
std::int64_t remove_cap_faces(Surface& surface, const std::vector<Index>& twins);

}  // namespace filmsticking
