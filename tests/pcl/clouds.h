// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>

namespace filmsticking::test {

/// Points spread evenly over the unit sphere.
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr make_sphere(int count) {
  typename pcl::PointCloud<PointT>::Ptr cloud(new pcl::PointCloud<PointT>);
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * i + 1) / count, radius = std::sqrt(1 - z * z), turn = 2.399963229728653 * i;
    PointT point;
    point.x = static_cast<float>(radius * std::cos(turn));
    point.y = static_cast<float>(radius * std::sin(turn));
    point.z = static_cast<float>(z);
    cloud->push_back(point);
  }
  cloud->header.frame_id = "scanner";
  cloud->header.stamp = 1234567;
  cloud->header.seq = 89;
  return cloud;
}

}  // namespace filmsticking::test
