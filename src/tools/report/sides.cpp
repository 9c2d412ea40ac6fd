// SPDX-License-Identifier: GPL-3.0-or-later
#include "sides.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>

namespace filmsticking::mesh_report {

std::vector<Side> sides_by_edge(const Surface& surface) {
  std::vector<Side> sides;
  sides.reserve(3 * surface.triangles.size());
  for (std::size_t f = 0; f < surface.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = surface.triangles[f][k], b = surface.triangles[f][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::int32_t>(f), k, a < b});
    }
  tbb::parallel_sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::tie(x.low, x.high, x.face) < std::tie(y.low, y.high, y.face);
  });
  return sides;
}

}  // namespace filmsticking::mesh_report
