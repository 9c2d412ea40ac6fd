// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::bench {

/// The points with their normals, as PCL takes them.
inline pcl::PointCloud<pcl::PointNormal>::Ptr with_normals(const std::vector<Point>& points,
                                                           const std::vector<Point>& normals) {
  pcl::PointCloud<pcl::PointNormal>::Ptr cloud(new pcl::PointCloud<pcl::PointNormal>);
  cloud->reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    pcl::PointNormal p;
    for (int k = 0; k < 3; ++k) {
      p.data[k] = static_cast<float>(points[i][k]);
      p.normal[k] = static_cast<float>(normals[i][k]);
    }
    cloud->push_back(p);
  }
  return cloud;
}

/// PCL's polygons as triangles.
inline std::vector<Triangle> to_triangles(const std::vector<pcl::Vertices>& polygons) {
  std::vector<Triangle> triangles;
  for (const pcl::Vertices& polygon : polygons)
    for (std::size_t k = 2; k < polygon.vertices.size(); ++k)
      triangles.push_back({static_cast<std::int32_t>(polygon.vertices[0]),
                           static_cast<std::int32_t>(polygon.vertices[k - 1]),
                           static_cast<std::int32_t>(polygon.vertices[k])});
  return triangles;
}

}  // namespace filmsticking::bench
