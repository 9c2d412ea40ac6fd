// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Puts sites into a closed manifold of sites: splits the nearest face into three, then flips the edges
/// around where that makes the triangles better. Both keep a closed oriented manifold whatever the geometry.
/// A site goes in only where none of the new faces turns its back on the split one, and within `reach` times
/// the longest edge of that face; the others are left off. Returns the number of sites put in.
std::int64_t insert_sites(Surface& film, const std::vector<Vec3>& sites, const std::vector<Index>& off,
                          double reach);

}  // namespace filmsticking
