// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "filmsticking/types.h"
#include "sample.h"

namespace filmsticking::bench {

/// A side of a plate: a point for every u and v in [0, 1].
using Side = std::function<Vec3(double u, double v)>;

/// Two sides, each of cells by cells quadrilaterals, and the rim between them. Outward where (d/du, d/dv,
/// upper - lower) is right-handed.
Mesh make_plate(int cells, const Side& lower, const Side& upper);

}  // namespace filmsticking::bench
