// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Takes away the caps of a film: faces with a corner on the opposite edge, as near as coordinates are
/// rounded. Rows of a depth image or of a grid leave them where points lie on one line. A cap has no area and
/// touches what it lies along; with that edge flipped, or the cap left out where the edge is at the border,
/// the surface is the same without.
///
/// The manifold stays one and its vertices stay on it; caps for which that cannot be are left. The same for
/// any numbering of vertices and faces. `twins`: the film's half_edge_twins() before. Returns how many.
std::int64_t remove_cap_faces(Surface& film, const std::vector<Index>& twins);

}  // namespace filmsticking
