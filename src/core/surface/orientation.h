// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filmsticking/types.h"
#include "geometry/surface.h"
#include "geometry/triangle_adjacency.h"

namespace filmsticking {

/// Orients the closed components of a manifold: outermost ones enclose positive volume, cavities negative
/// volume. Components with a boundary keep their orientation.
///
/// The positions of the surface, which may be perturbed, decide which component contains which. The exact
/// `places` of its vertices decide the sign of a volume, which may be smaller than the perturbation.
/// `topology`: that of the triangles before. Returns false if all components are closed and none encloses any
/// volume.
bool orient_components(Surface& surface, const PointsView& places, const SurfaceTopology& topology);

/// The winding number of a closed surface around x: the solid angles of its triangles, over 4 pi.
double solid_angle_winding(const Surface& surface, const std::vector<Index>& triangles, const Vec3& x);

}  // namespace filmsticking
