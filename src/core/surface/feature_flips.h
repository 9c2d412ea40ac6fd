// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/surface.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// Flips edges of a surface of sites so that they lie along sharp edges and along the bends of curved parts
/// (paper, section 4, for CAD models). Every flip lowers the sum over edges of length times change of normal,
/// by more than the roughness around it. Vertices, topology and boundary stay. No flip makes faces intersect:
/// the tetrahedron that it sweeps contains no other face.
///
/// `twins`: the surface's half_edge_twins(); updated. `viewpoint`: all faces show their fronts to it, before
/// and after; or null. Fast if near faces have near numbers. The same flips for any number of threads. Throws
/// Cancelled. Returns the number of flips.
std::int64_t flip_to_features(Surface& surface, std::vector<Index>& twins, const Cancel& cancel = {},
                              const Vec3* viewpoint = nullptr);

}  // namespace filmsticking
