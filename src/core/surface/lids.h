// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"
#include "geometry/work_limits.h"
#include "surface/rims.h"

namespace filmsticking {

/// A rim of an open surface: its vertices, and whether it has got a lid.
struct Opening {
  Rim rim;
  bool closed = false;
};

/// Gives a lid to every rim of a manifold whose diameter is at most `most`, in the unit of the positions: its
/// triangulation of least cost, or for a long one its Delaunay triangulation in its plane. Faces are
/// appended; no vertex is, and the surface stays a manifold. Of several lids the one that meets fewest other
/// faces is taken. A rim stays open if every lid would repeat an edge or lie on the faces inside the rim, or
/// if it has more than 2,000 corners and crosses itself as seen along its normal.
///
/// Returns all rims as they were, in the order of find_rims(). `twins`: the half_edge_twins() before. Fast if
/// near faces have near numbers. Throws Cancelled.
std::vector<Opening> close_rims(Surface& surface, const std::vector<Index>& twins, double most,
                                const Cancel& cancel = {});

}  // namespace filmsticking
