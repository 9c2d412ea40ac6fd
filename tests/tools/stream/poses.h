// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <utility>

#include "stream/frame.h"

namespace filmsticking::stream {

inline Pose pose(double x, double y, double z, double angle, const Eigen::Vector3d& axis) {
  return Pose(Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(angle, axis.normalized()));
}

/// Rotation in radians and shift between two poses.
inline std::pair<double, double> difference(const Pose& a, const Pose& b) {
  const Pose between = a.inverse() * b;
  return {Eigen::AngleAxisd(between.linear()).angle(), between.translation().norm()};
}

}  // namespace filmsticking::stream
