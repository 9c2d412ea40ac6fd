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

CloudFit cloud_fit(const Surface& mesh, const std::vector<Point>& cloud);

}  // namespace filmsticking::mesh_report
