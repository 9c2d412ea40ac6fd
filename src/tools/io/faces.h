// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of meshes have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "io_error.h"
#include "model.h"

namespace filmsticking::io {

[[noreturn]] inline void throw_no_vertex() {
  throw IoError("a face in it names a vertex that does not exist");
}

/// A file's number of a vertex, from zero. Throws IoError if it cannot be one.
inline std::int32_t corner_index(double value) {
  if (!(value >= 0 && value < INT32_MAX)) throw_no_vertex();
  return static_cast<std::int32_t>(value);
}

/// Appends a polygon as a fan of triangles.
inline void append_polygon(const std::vector<std::int32_t>& corners, Model& model) {
  for (std::size_t k = 2; k < corners.size(); ++k)
    model.triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

/// Once all is read, as faces may come before points. Throws IoError.
inline void check_corners(const Model& model) {
  for (const Triangle& triangle : model.triangles)
    for (const std::int32_t corner : triangle)
      if (static_cast<std::size_t>(corner) >= model.positions.size()) throw_no_vertex();
}

}  // namespace filmsticking::io
