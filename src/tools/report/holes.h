// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sides.h"
#include "surface.h"

namespace filmsticking::mesh_report {

/// A loop of edges with one face: a hole, or the outer rim of an open component.
struct Hole {
  std::vector<std::int32_t> vertices;  ///< in order; a loop of n has n edges
  double length = 0;
  double diameter = 0;         ///< of the smallest ball around it
  Vec3 centre = Vec3::Zero();  ///< of that ball
  /// The area of a flat lid, along the normal that the faces around continue: half the sum of the cross
  /// products of the edges' ends.
  Vec3 area_vector = Vec3::Zero();

  double area() const { return area_vector.norm(); }
};

/// All holes, the widest first. Loops repeat no vertex: where holes touch, they are several.
std::vector<Hole> holes(const Surface& surface, const std::vector<Side>& sides_by_edge);

}  // namespace filmsticking::mesh_report
