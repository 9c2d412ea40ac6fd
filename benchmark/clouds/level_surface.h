// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "filmsticking/types.h"
#include "sample.h"

namespace filmsticking::bench {

/// Like a signed distance: negative inside.
using Field = std::function<double(const Vec3&)>;

/// The closed, outward surface where `field` is zero, on a grid of cells of side `cell`. The field must be
/// positive on the border of the box. Throws std::invalid_argument where the box has too many cells.
Mesh make_level_surface(const Field& field, const Vec3& low, const Vec3& high, double cell);

}  // namespace filmsticking::bench
