// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace filmsticking {

/// The Euler characteristic V - E + F of a triangle mesh. `boundary_edges`: edges with one face; all others
/// have two.
inline std::int64_t euler_characteristic(std::int64_t vertices, std::int64_t faces,
                                         std::int64_t boundary_edges) {
  const std::int64_t edges = (3 * faces + boundary_edges) / 2;
  return vertices - edges + faces;
}

/// The genus of an orientable surface, summed over its components: the number of its handles.
inline std::int64_t genus(std::int64_t components, std::int64_t euler, std::int64_t boundary_loops) {
  return (2 * components - euler - boundary_loops) / 2;
}

}  // namespace filmsticking
