// SPDX-License-Identifier: GPL-3.0-or-later
// The plain types that cross the library's border.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace filmsticking {

/// A position: x, y, z in the caller's unit.
using Point = std::array<double, 3>;

/// Three vertex indices, counter-clockwise seen from outside.
using Triangle = std::array<std::int32_t, 3>;

/// An indexed triangle mesh.
struct Mesh {
  std::vector<Point> positions;     ///< of the vertices
  std::vector<Triangle> triangles;  ///< indices into `positions`
};

}  // namespace filmsticking
