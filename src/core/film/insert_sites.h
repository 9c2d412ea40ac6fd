// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Inserts the sites `off` into a closed manifold of sites: splits the nearest face into three, then flips
/// edges around it if the triangles improve. Both keep a closed oriented manifold whatever the geometry.
/// Returns the number of inserted sites.
///
/// A site stays off if its distance from the face exceeds `reach` times the face's longest edge. It also
/// stays off if more than one of the new faces would be turned against the split one.
std::int64_t insert_sites(Surface& film, const std::vector<Vec3>& sites, const std::vector<Index>& off,
                          double reach);

}  // namespace filmsticking
