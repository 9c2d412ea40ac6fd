// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/model.h"
#include "report/surface_distance.h"

namespace filmsticking::scene {

/// How far things are from a reference surface, in its unit.
class Deviation {
 public:
  /// Throws io::IoError where no face of the reference has finite corners.
  explicit Deviation(const io::Model& reference);

  /// For each point; NaN where the point is not finite.
  std::vector<double> of_points(const std::vector<Point>& points) const;

  /// For each face of a mesh, the largest of the distances of its corners and of its middle (a mesh through
  /// samples of the reference is right in its corners, whatever is between them). NaN where a corner is not
  /// finite.
  std::vector<double> of_faces(const io::Model& mesh) const;

 private:
  mesh_report::Frame frame_;
  mesh_report::Surface surface_;
  mesh_report::SurfaceDistance distance_;
};

/// The length of a colour scale for distances: the first of 1, 2, 5, 10, 20 .. (or a power of ten of these)
/// that all but the farthest hundredth stay below, so that strays do not flatten the colours. 1 where
/// there is no distance but zero.
double scale_length(std::vector<double> distances);

}  // namespace filmsticking::scene
