// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "filmsticking/types.h"
#include "io/cloud.h"

namespace filmsticking::mesh_report {

using Vec3 = Eigen::Vector3d;

/// The faces of a mesh as they are judged. Vertices at the same position are one, as some formats (STL)
/// repeat corners. Every vertex has a face, and no face repeats a vertex.
struct Surface {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;

  const Vec3& corner(std::size_t triangle, int k) const { return positions[triangles[triangle][k]]; }
  /// Twice the area, along the normal.
  Vec3 area_vector2(std::size_t triangle) const;
};

/// Leaves out faces that repeat a vertex or have a corner that is not usable(). Keeps the order of faces.
Surface make_surface(const pcl::PolygonMesh& mesh);

/// Finite, and small enough that squares and their sums are too.
bool usable(const Point& p);

/// The map of a box to the unit box: its centre becomes the origin, its longest side 1.
struct Frame {
  Vec3 centre = Vec3::Zero();
  double side = 1;  ///< longest side; 0 for a single point
  double diagonal = 0;

  Vec3 to_unit(const Vec3& p) const { return (p - centre) / (side > 0 ? side : 1); }
  Surface to_unit(Surface surface) const;
};

/// Of the points' box.
Frame frame_of(const std::vector<Vec3>& points);

}  // namespace filmsticking::mesh_report
