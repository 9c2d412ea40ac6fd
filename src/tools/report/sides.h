// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "surface.h"

namespace filmsticking::mesh_report {

/// One side of a face: an edge with its ends in ascending order, and how the face runs along it.
struct Side {
  std::int32_t low, high, face;
  int corner;  ///< of the face, where the side begins
  bool forward;

  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
  /// Where the face comes from and goes to.
  std::int32_t begin() const { return forward ? low : high; }
  std::int32_t end() const { return forward ? high : low; }
};

/// All sides, grouped by edge: by low, high, face.
std::vector<Side> sides_by_edge(const Surface& surface);

}  // namespace filmsticking::mesh_report
