// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::bench {

/// Unit normals by pcl::NormalEstimation from 18 neighbours, turned away from the centroid, as PCL's tutorial
/// on Poisson does: PCL has no orientation but towards a viewpoint.
std::vector<Point> pcl_normals(const std::vector<Point>& points);

}  // namespace filmsticking::bench
