// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "filmsticking/types.h"
#include "filters/filter_options.h"
#include "frame.h"

namespace filmsticking::stream {

/// The finite points of a frame that pass the filters, as one row with all fields. Throws StreamError, also
/// if no point is left.
pcl::PCLPointCloud2 frame_points(const Frame& frame, const filters::FilterOptions& filters);

/// The points with numbers for which `keep` is true, as one row with all fields. The points must lie within
/// the cloud's bytes.
pcl::PCLPointCloud2 points_where(const pcl::PCLPointCloud2& cloud,
                                 const std::function<bool(std::size_t point)>& keep);

/// The points whose distance from the sensor, at the origin, is within [least, most], as one row with all
/// fields; `most` 0: no upper bound. Throws io::IoError for a cloud without positions.
pcl::PCLPointCloud2 in_range(const pcl::PCLPointCloud2& cloud, double least, double most);

/// Moves points from the sensor's coordinates to the world's, in double precision.
std::vector<Point> moved(std::vector<Point> points, const Pose& pose);

/// Mean distance from a point to its nearest neighbour; zero for fewer than two points. Estimated from about
/// a thousand of the points.
double mean_spacing(const std::vector<Point>& points);

}  // namespace filmsticking::stream
