// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::bench {

/// Unit normals by principal components of the 18 nearest points, oriented along a minimum spanning tree,
/// outward at the highest point (CGAL pca_estimate_normals and mst_orient_normals). Normals that the tree
/// does not reach keep their estimated sign.
std::vector<Point> oriented_normals(const std::vector<Point>& points);

/// The depth of a Poisson octree whose cells are about half as wide as the cloud's spacing: 8 for 10,000
/// points, 10 for 100,000, 11 for 1,000,000.
int poisson_depth(std::size_t points);

}  // namespace filmsticking::bench
