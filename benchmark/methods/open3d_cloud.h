// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <open3d/geometry/PointCloud.h>
#include <open3d/geometry/TriangleMesh.h>

#include <vector>

#include "filmsticking/types.h"
#include "oriented_normals.h"

namespace filmsticking::bench {

/// The points with oriented normals, as Open3D takes them.
inline open3d::geometry::PointCloud open3d_with_normals(const std::vector<Point>& points) {
  open3d::geometry::PointCloud cloud;
  for (const Point& p : points) cloud.points_.emplace_back(p[0], p[1], p[2]);
  for (const Point& n : oriented_normals(points)) cloud.normals_.emplace_back(n[0], n[1], n[2]);
  return cloud;
}

inline Mesh from_open3d(const open3d::geometry::TriangleMesh& mesh) {
  Mesh out;
  for (const Eigen::Vector3d& p : mesh.vertices_) out.positions.push_back({p.x(), p.y(), p.z()});
  for (const Eigen::Vector3i& t : mesh.triangles_) out.triangles.push_back({t.x(), t.y(), t.z()});
  return out;
}

}  // namespace filmsticking::bench
