// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// [vertex] unit normals. On a smooth surface those of surface_normals(); on a rough one, as through noise,
/// sums of area vectors within three edges: the sum over a patch depends on its rim alone, however it is
/// crumpled inside. A vertex without either gets the direction from the middle of the surface. Throws
/// Cancelled.
std::vector<Vec3> vertex_normals(const Surface& surface, const Cancel& cancel = {});

}  // namespace filmsticking
