// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filmsticking/reconstruct.h"
#include "io/model.h"

namespace filmsticking::app {

/// The mesh of a result as a model, with the colours of the cloud that it came from.
inline io::Model mesh_model(const io::Model& cloud, const Result& result) {
  io::Model mesh;
  mesh.triangles = result.triangles;
  for (const std::int32_t index : result.vertices) {
    mesh.positions.push_back(cloud.positions[index]);
    if (!cloud.colours.empty()) mesh.colours.push_back(cloud.colours[index]);
  }
  return mesh;
}

/// Why a result is not Ok, as a clause for the user.
inline std::string reason(const Result& result) {
  return result.message.empty() ? describe(result.status) : result.message;
}

}  // namespace filmsticking::app
