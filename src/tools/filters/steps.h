// SPDX-License-Identifier: GPL-3.0-or-later
// The filters one by one. They take one row without padding: finite points whose x, y, z are FLOAT32.
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <vector>

#include "filter_options.h"

namespace filmsticking::filters {

/// The points that pcl::StatisticalOutlierRemoval keeps, ascending.
std::vector<int> inliers(const pcl::PCLPointCloud2& cloud, const OutlierRule& rule);

/// By pcl::VoxelGrid. Throws FilterError where it could not number the cells.
pcl::PCLPointCloud2 one_point_a_voxel(const pcl::PCLPointCloud2& cloud, double leaf);

/// By pcl::MovingLeastSquares. Points with fewer than three neighbours in the radius are left out.
pcl::PCLPointCloud2 smoothed(const pcl::PCLPointCloud2& cloud, double radius);

}  // namespace filmsticking::filters
