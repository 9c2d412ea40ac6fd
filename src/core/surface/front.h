// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"
#include "geometry/triangle_adjacency.h"

namespace filmsticking {

/// Turns over the components with a boundary that show their backs to what saw them, by the angles at which
/// the lines of sight meet their faces. `viewpoints`: [site], not finite if unknown. `topology`: that of the
/// triangles before. Returns the number of components turned.
Index turn_to_sensors(Surface& surface, const SurfaceTopology& topology, const std::vector<Vec3>& viewpoints);

}  // namespace filmsticking
