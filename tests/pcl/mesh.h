// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include "filmsticking/types.h"

namespace filmsticking::test {

/// A triangle mesh of PCL as one that surface_fault() reads; a polygon that is no triangle makes it broken.
inline Mesh to_mesh(const pcl::PolygonMesh& polygon_mesh) {
  pcl::PointCloud<pcl::PointXYZ> points;
  pcl::fromPCLPointCloud2(polygon_mesh.cloud, points);
  Mesh mesh;
  for (const pcl::PointXYZ& p : points) mesh.positions.push_back({p.x, p.y, p.z});
  for (const pcl::Vertices& polygon : polygon_mesh.polygons) {
    const pcl::Indices& v = polygon.vertices;
    mesh.triangles.push_back(v.size() == 3 ? Triangle{v[0], v[1], v[2]} : Triangle{-1, -1, -1});
  }
  return mesh;
}

}  // namespace filmsticking::test
