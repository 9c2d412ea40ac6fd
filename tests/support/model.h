// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "io/cloud.h"

namespace filmsticking::test {

/// Clouds and meshes as plain numbers, for expectations. Converts from and to PCL's types.
struct Model {
  std::vector<Point> positions;
  std::vector<io::Colour> colours;
  std::vector<Triangle> triangles;
  std::optional<Point> viewpoint = std::nullopt;

  Model() = default;
  Model(std::vector<Point> p, std::vector<io::Colour> c, std::vector<Triangle> t)
      : positions(std::move(p)), colours(std::move(c)), triangles(std::move(t)) {}
  Model(const pcl::PCLPointCloud2& cloud)
      : positions(io::positions_of(cloud)), colours(io::colours_of(cloud)) {}
  Model(const io::Cloud& cloud) : Model(cloud.points) { viewpoint = cloud.viewpoint; }
  Model(const pcl::PolygonMesh& mesh) : Model(mesh.cloud) { triangles = io::triangles_of(mesh.polygons); }

  operator pcl::PolygonMesh() const { return io::make_mesh(io::make_cloud(positions, colours), triangles); }
};

}  // namespace filmsticking::test
