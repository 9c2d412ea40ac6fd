// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <limits>

#include "geometry/vec.h"

namespace filmsticking {

/// The squared circumradius of a triangle; the largest double for one without area.
inline double circumradius2(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = (b - c).squaredNorm(), lb = (c - a).squaredNorm(), lc = (a - b).squaredNorm();
  const double area2 = (b - a).cross(c - a).squaredNorm();
  return area2 > 0 ? la * lb * lc / (4 * area2) : std::numeric_limits<double>::max();
}

}  // namespace filmsticking
