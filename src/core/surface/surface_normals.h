// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Outward unit normals at the sites of a surface. Each is the sum over the faces around a vertex, weighted
/// by the angle there over the square of the longest edge: small faces are more reliable. All vertices must
/// be sites. `otherwise`: one normal per site, kept where a site has no face or only flat ones.
std::vector<Vec3> surface_normals(const Surface& surface, std::vector<Vec3> otherwise);

}  // namespace filmsticking
