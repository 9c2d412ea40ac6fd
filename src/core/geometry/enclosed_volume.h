// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filmsticking/types.h"
#include "geometry/vec.h"

namespace filmsticking {

/// The sign, -1, 0 or 1, of the volume enclosed by the triangles of a closed surface; positive if they wind
/// counter-clockwise seen from outside. Exact at every scale. `triangles` index `places`, which are finite.
int enclosed_volume_sign(const std::vector<Corners>& triangles, const PointsView& places);

/// A power of two for rounded_volume(). Volumes by the same unit can be compared.
double enclosing_unit(const PointsView& places);

/// The absolute volume enclosed by the triangles of a closed surface, up to rounding, in an arbitrary unit
/// that depends on `unit` only. `triangles`, at least one, index `places`, which are finite.
double rounded_volume(const std::vector<Corners>& triangles, const PointsView& places, double unit);

}  // namespace filmsticking
