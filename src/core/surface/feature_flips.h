// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/surface.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// Flips edges of a film of sites so that they lie along the sharp edges of the shape and along the bends of
/// its curved parts (as the paper does for models of CAD; section 4): the sum over edges of length times the
/// change of normal falls with every flip, by more than the roughness around it. The sites on the film, its
/// topology and its border stay, and no flip makes faces intersect: the tetrahedron that it sweeps is free of
/// other faces.
///
/// `viewpoint`: what all faces show their fronts to, before and after, or null. `twins`: the film's
/// half_edge_twins(), before and after. Faces that are near each other should have near numbers. The same
/// flips for any number of threads. Returns how many.
std::int64_t flip_to_features(Surface& film, std::vector<Index>& twins, const Cancel& cancel = {},
                              const Vec3* viewpoint = nullptr);

}  // namespace filmsticking
