// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace filmsticking::bench {

using Vec3 = Eigen::Vector3d;

/// A point of a surface and the normal of the face that it was drawn from.
struct Sample {
  Vec3 position;
  Vec3 normal;
};

}  // namespace filmsticking::bench
