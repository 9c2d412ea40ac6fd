// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filmsticking/types.h"
#include "geometry/surface.h"
#include "geometry/triangle_adjacency.h"

namespace filmsticking {

/// Turns the closed components of a manifold so that outermost ones enclose positive volume and cavities
/// negative volume; those with a boundary stay as they are. What a component is inside of is decided by the
/// surface, which may be perturbed; the sign of a volume, by the true `places` of its vertices, between which
/// there can be less than a perturbation. `topology` is that of its triangles before. False if all components
/// are closed and none encloses any volume.
bool orient_components(Surface& surface, const PointsView& places, const SurfaceTopology& topology);

/// The winding number of a closed surface around x: the sum of its triangles' solid angles over 4 pi.
double solid_angle_winding(const Surface& surface, const std::vector<Index>& triangles, const Vec3& x);

}  // namespace filmsticking
