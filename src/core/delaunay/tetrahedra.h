// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "geometry/unset_vector.h"
#include "geometry/vec.h"

namespace filmsticking {

/// The tetrahedra of a triangulation, infinite ones included.
struct Tetrahedra {
  UnsetVector<std::array<Index, 4>> corners;     ///< positively oriented; kNone is the infinite vertex
  UnsetVector<std::array<Index, 4>> neighbours;  ///< across the facet opposite corner k

  std::size_t size() const { return corners.size(); }
  bool infinite(Index t) const {
    const auto& c = corners[t];
    return c[0] == kNone || c[1] == kNone || c[2] == kNone || c[3] == kNone;
  }
};

}  // namespace filmsticking
