// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "surface.h"

namespace filmsticking::mesh_report {

/// The sharp edges of the truth that a mesh could have.
struct SharpEdges {
  std::int64_t edges = 0;  ///< of two faces that bend by more than kSharp, both ends vertices of the mesh
  std::optional<double> restored;  ///< percent of these that are edges of the mesh; none without such edges
};

constexpr double kSharp = 30;  // degrees between the normals

/// Vertices of the two are the same where their places are, rounded to single precision.
SharpEdges sharp_edges(const Surface& mesh, const Surface& truth);

}  // namespace filmsticking::mesh_report
