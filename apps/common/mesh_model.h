// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filmsticking/reconstruct.h"
#include "io/model.h"

namespace filmsticking::app {

/// The mesh of a result as a model, with the colours of the cloud that it came from.
/// Made of the cloud itself where that is handed over: no second copy of the points is needed.
inline io::Model mesh_model(io::Model cloud, const Result& result) {
  const auto keep = [&](auto& rows) {
    if (rows.empty()) return;
    std::size_t kept = 0;
    for (const std::int32_t index : result.vertices) rows[kept++] = rows[index];  // the indices ascend
    rows.resize(kept);
  };
  keep(cloud.positions);
  keep(cloud.colours);
  cloud.triangles = result.triangles;
  return cloud;
}

/// Why a result is not Ok, as a clause for the user.
inline std::string reason(const Result& result) {
  return result.message.empty() ? describe(result.status) : result.message;
}

}  // namespace filmsticking::app
