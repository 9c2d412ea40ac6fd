// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "surface.h"

namespace filmsticking::mesh_report {

/// Where counting ends: a mesh crumpled into itself has pairs by the square of its faces.
constexpr std::int64_t kMostIntersections = 10'000'000;

struct SelfIntersections {
  std::int64_t pairs = 0;        ///< never more than kMostIntersections
  std::vector<char> face_meets;  ///< for each face whether it is in one of the pairs that were counted
};

/// Pairs of faces that meet elsewhere than in the corners and edges they share, by exact predicates. Two
/// faces on the same three corners are a pair; a face without area is in none but such.
SelfIntersections self_intersections(const Surface& surface);

}  // namespace filmsticking::mesh_report
