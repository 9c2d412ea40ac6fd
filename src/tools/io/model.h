// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "cloud.h"

namespace filmsticking::io {

/// Positions, colours and triangles alone: the former type of clouds and meshes, which loses all other
/// fields. Converts from and to PCL's types.
struct Model {
  std::vector<Point> positions;
  std::vector<Colour> colours;      ///< empty, or one a position
  std::vector<Triangle> triangles;  ///< empty for a point cloud
  std::optional<Point> viewpoint = std::nullopt;

  Model() = default;
  Model(std::vector<Point> p, std::vector<Colour> c, std::vector<Triangle> t)
      : positions(std::move(p)), colours(std::move(c)), triangles(std::move(t)) {}
  Model(const Cloud& cloud)
      : positions(positions_of(cloud.points)),
        colours(colours_of(cloud.points)),
        viewpoint(cloud.viewpoint) {}
  Model(const pcl::PolygonMesh& mesh)
      : positions(positions_of(mesh.cloud)),
        colours(colours_of(mesh.cloud)),
        triangles(triangles_of(mesh.polygons)) {}

  operator pcl::PolygonMesh() const { return make_mesh(make_cloud(positions, colours), triangles); }
};

}  // namespace filmsticking::io
