// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Unit normals of a film, all of whose vertices are sites, at these, outward: of the faces around each,
/// weighed by their angle there over the square of their longest edge, since short faces tell more.
/// `otherwise`: one per site, kept where a site is on no face, or on flat ones only.
std::vector<Vec3> surface_normals(const Surface& film, std::vector<Vec3> otherwise);

}  // namespace filmsticking
