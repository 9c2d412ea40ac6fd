// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filmsticking/types.h"
#include "geometry/vec.h"

namespace filmsticking {

/// The points with their heights along `direction` scaled to the unit of the plane across it, where the two
/// units differ: metres beside degrees. Neighbours in space are then neighbours on the map. Empty where the
/// points need no scaling: they are not much higher than wide, or not steep, or fewer than 16. Not finite
/// points stay as they are. `direction`: of any length but zero.
std::vector<Point> in_even_units(const PointsView& points, const Vec3& direction);

}  // namespace filmsticking
