// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sample.h"

namespace filmsticking::bench {

/// A box along the axes.
struct Box {
  Vec3 low, high;

  bool contains(const Vec3& p) const {
    return (p.array() > low.array()).all() && (p.array() < high.array()).all();
  }
};

/// An upright cylinder that stands on z = 0.
struct Pole {
  double x, y, radius, height;
};

/// What rays may hit.
struct RayScene {
  std::vector<Box> rooms;  ///< hollow: a ray hits the walls of their union from inside
  std::vector<Box> boxes;
  std::vector<Pole> poles;
  bool ground = false;  ///< the plane z = 0

  /// The distance along a unit ray; infinite if it hits nothing. The eye is in a room if there is one, and in
  /// no box.
  double first_hit(const Vec3& eye, const Vec3& ray) const;
};

}  // namespace filmsticking::bench
