// SPDX-License-Identifier: GPL-3.0-or-later
// The filters one by one. Those after the first take what it gives: one row without padding, all finite.
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "filter_options.h"

namespace filmsticking::filters {

/// The finite points, in the box if there is one, as one row without padding. Throws FilterError for a cloud
/// whose fields and bytes do not fit together.
pcl::PCLPointCloud2 finite_points(const pcl::PCLPointCloud2& cloud, const std::optional<Box>& box);

/// By pcl::StatisticalOutlierRemoval.
pcl::PCLPointCloud2 without_outliers(const pcl::PCLPointCloud2& cloud, const OutlierRule& rule);

/// By pcl::VoxelGrid. Throws FilterError where it could not number the cells.
pcl::PCLPointCloud2 one_point_a_voxel(const pcl::PCLPointCloud2& cloud, double leaf);

/// By pcl::MovingLeastSquares. Points with fewer than three neighbours in the radius are left out.
pcl::PCLPointCloud2 smoothed(const pcl::PCLPointCloud2& cloud, double radius);

}  // namespace filmsticking::filters
