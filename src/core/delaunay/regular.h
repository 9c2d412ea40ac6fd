// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedra.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// The regular triangulation of weighted sites, infinite tetrahedra included, by CGAL on one thread; none if
/// all sites lie on a plane. A site that another one hides has no tetrahedron; of sites at the same place one
/// counts. `weights`: per site; empty: Delaunay. In no particular order. Throws TooManyTetrahedra as soon as
/// the sites inserted so far make more than the limit, and Cancelled.
Tetrahedra regular_tetrahedra(const std::vector<Vec3>& sites, const std::vector<double>& weights,
                              const TriangulationLimits& limits = {});

}  // namespace filmsticking
