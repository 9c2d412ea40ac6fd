// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "guiding_surface.h"

namespace filmsticking {

/// Turns the components of a closed manifold so that outermost ones enclose positive volume and cavities
/// negative volume.
void orient_components(GuidingSurface& surface);

/// The winding number of a closed surface around x: the sum of its triangles' solid angles over 4 pi.
double solid_angle_winding(const GuidingSurface& surface, const std::vector<Index>& triangles, const Vec3& x);

}  // namespace filmsticking
