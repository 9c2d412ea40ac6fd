// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "sample.h"

namespace filmsticking::bench {

/// A tube from a to b with balls for ends; a and b differ.
struct Capsule {
  Vec3 a, b;
  double radius;

  /// Signed: negative inside.
  double distance(const Vec3& p) const {
    const Vec3 along = b - a;
    const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - a - t * along).norm() - radius;
  }
};

}  // namespace filmsticking::bench
