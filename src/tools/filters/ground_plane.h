// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::filters {

/// The plane that things stand on.
struct GroundPlane {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< of length 1
  double offset = 0;

  /// Above it, in the cloud's unit.
  double height(const Eigen::Vector3d& p) const { return up.dot(p) + offset; }
};

/// What `--ground` was given.
struct GroundChoice {
  bool asked = false;
  std::optional<GroundPlane> plane;  ///< none: it is to be found
};

/// "A,B,C,D": the plane Ax + By + Cz + D = 0, where (A, B, C) points up; or "auto". Throws FilterError.
GroundChoice parse_ground(const std::string& text);

/// The plane with the most points near it, by pcl::SACSegmentation (RANSAC), then by least squares. Up is the
/// side with more of the other points. The same points give the same plane. Throws FilterError where it has
/// fewer than a twentieth of the points.
GroundPlane find_ground(const std::vector<Point>& points);

/// The typical distance from a point to the nearest at another place; 0 without any.
double usual_distance(const std::vector<Point>& points);

/// The deviation of the ground from its plane, by the median of what is below it, where nothing else is, but
/// no deeper than `reach`; 0 without any.
double ground_noise(const std::vector<double>& heights, double reach);

/// "0.0000 x + 0.0000 y + 1.0000 z - 0.25 = 0".
std::string to_text(const GroundPlane& plane);

}  // namespace filmsticking::filters
