// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/vec.h"

namespace filmsticking {

/// The constrained Delaunay triangulation of a polygon, seen along its area vector, by its corners: faces of
/// positions in its direction. Empty if the polygon crosses itself as it is seen, or has no area. Takes n log
/// n time.
std::vector<Corners> plane_triangulation(const std::vector<Vec3>& corners);

}  // namespace filmsticking
