// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"
#include "geometry/work_limits.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// The share of a surface's sites at which it goes to and fro between two layers of places, such as the sides
/// of a wall, by a sample of them: it is against the plane fitted to the neighbours there, and noise does not
/// say why.
///
/// Noise has places off a smooth surface by deviations of any size, mostly small ones: the kurtosis of these
/// is near 3. Two layers have them half their distance off the middle: it is near 1. Layers that are too far
/// apart for neighbours to be on both are flat by themselves.
double share_between_layers(const Surface& surface, const std::vector<Vec3>& places,
                            const SiteGeometry& geometry, const Cancel& cancel = {});

}  // namespace filmsticking
