// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/cloud.h"
#include "report/surface_distance.h"

namespace filmsticking::scene {

/// Distances to a reference surface, in its unit.
class Deviation {
 public:
  /// Throws io::IoError where no face of the reference has finite corners.
  explicit Deviation(const pcl::PolygonMesh& reference);

  /// For each point; NaN where the point is not finite.
  std::vector<double> of_points(const std::vector<Point>& points) const;

  /// For each face of a mesh, the largest distance of its corners and its middle: the corners of a mesh
  /// through samples of the reference have none. NaN where a corner is not finite.
  std::vector<double> of_faces(const pcl::PolygonMesh& mesh) const;

 private:
  mesh_report::Frame frame_;
  mesh_report::Surface surface_;
  mesh_report::SurfaceDistance distance_;
};

}  // namespace filmsticking::scene
