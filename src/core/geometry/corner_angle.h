// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "geometry/vec.h"

namespace filmsticking {

/// The angle at `apex` between the directions to p and q, 0 to pi; 0 if p or q equals the apex.
inline double corner_angle(const Vec3& apex, const Vec3& p, const Vec3& q) {
  const Vec3 u = p - apex, v = q - apex;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace filmsticking
