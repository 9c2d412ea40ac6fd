// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "surface.h"

namespace filmsticking::mesh_report {

/// A mesh against the points it was made from.
struct CloudFit {
  std::int64_t points = 0;  ///< distinct usable positions
  /// Percent of them with a vertex of the mesh within 1e-7 of the diagonal of the points' box.
  double interpolated = 0;
  /// From the points to the mesh, in the cloud's unit; none without points or faces.
  std::optional<double> distance_mean, distance_max;
};

/// The distinct usable positions of a cloud, and how far the mesh is from each; no distances without faces.
struct CloudDistances {
  std::vector<Vec3> points;
  std::vector<double> to_mesh;
};

CloudDistances cloud_distances(const Surface& mesh, const std::vector<Point>& cloud);

CloudFit cloud_fit_of(const Surface& mesh, const CloudDistances& distances);
inline CloudFit cloud_fit(const Surface& mesh, const std::vector<Point>& cloud) {
  return cloud_fit_of(mesh, cloud_distances(mesh, cloud));
}

}  // namespace filmsticking::mesh_report
