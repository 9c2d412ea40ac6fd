// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/vec.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// Do the sites fill a volume, as the nodes of a finite element mesh do, and lie not only on its surface? Two
/// signs must agree at the median site: its neighbours vary as much off their plane as in it, and the number
/// of sites grows with the cube of the distance, not with its square. False for fewer than 200 sites.
bool fills_volume(const std::vector<Vec3>& sites, const SiteGeometry& geometry);

}  // namespace filmsticking
