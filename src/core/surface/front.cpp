// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/front.h"

#include <algorithm>
#include <utility>

namespace filmsticking {

Index turn_to_sensors(Surface& surface, const SurfaceTopology& topology,
                      const std::vector<Vec3>& viewpoints) {
  std::vector<double> front(static_cast<std::size_t>(topology.components), 0);
  std::vector<char> open(front.size(), 0);
  for (Index t = 0; t < static_cast<Index>(topology.component.size()); ++t) {
    const Index c = topology.component[t];
    const Vec3 area = surface.area_vector2(t);
    for (int k = 0; k < 3; ++k) {
      open[c] = open[c] || topology.twin[3 * t + k] == kNone;
      const Index corner = surface.triangles[t][k];
      const Vec3 line = viewpoints[surface.site[corner]] - surface.positions[corner];
      if (line.allFinite()) front[c] += area.dot(line.stableNormalized());
    }
  }
  for (Index t = 0; t < static_cast<Index>(topology.component.size()); ++t) {
    const Index c = topology.component[t];
    if (open[c] && front[c] < 0) std::swap(surface.triangles[t][1], surface.triangles[t][2]);
  }
  Index turned = 0;
  for (std::size_t c = 0; c < front.size(); ++c) turned += open[c] && front[c] < 0;
  return turned;
}

}  // namespace filmsticking
