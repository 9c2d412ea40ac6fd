// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filmsticking/types.h"
#include "geometry/vec.h"

namespace filmsticking {

/// The sign, -1, 0 or 1, of the volume that some triangles of a closed surface enclose; exact, also where it
/// is less than what rounding leaves. `triangles` index `places`, which are finite.
int enclosed_volume_sign(const std::vector<Corners>& triangles, const PointsView& places);

/// A power of two for rounded_volume(): volumes in the same one can be compared.
double enclosing_unit(const PointsView& places);

/// What some triangles of a closed surface enclose, without its sign and but for rounding, in a unit of its
/// own that only depends on `unit`. `triangles`, one at least, index `places`, which are finite.
double rounded_volume(const std::vector<Corners>& triangles, const PointsView& places, double unit);

}  // namespace filmsticking
