// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "cloud.h"
#include "filmsticking/types.h"

namespace filmsticking::io {

/// What a file of points or of a mesh holds. Positions have the very value of the file.
struct Model {
  std::vector<Point> positions;
  std::vector<Colour> colours;      ///< empty, or one a position
  std::vector<Triangle> triangles;  ///< empty for a point cloud; polygons come as fans of triangles
  std::optional<Point> viewpoint = std::nullopt;  ///< where the sensor was, where that is said
};

}  // namespace filmsticking::io
