// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"
#include "geometry/work_limits.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// The share of a surface's sites at which the surface zigzags between two layers of sites, such as the sides
/// of a wall. Estimated from a sample. At such a site the surface disagrees with the plane fitted to the
/// neighbours, and noise does not explain it.
///
/// Noise scatters sites around a smooth surface, mostly by small distances: the kurtosis of the distances is
/// near 3. Two layers are both half their distance off the middle: the kurtosis is near 1. Layers too far
/// apart to share neighbours are each flat. `places`: of all sites, indexed by surface.site.
double share_between_layers(const Surface& surface, const std::vector<Vec3>& places,
                            const SiteGeometry& geometry, const Cancel& cancel = {});

}  // namespace filmsticking
