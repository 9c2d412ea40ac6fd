// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/front.h"

#include <algorithm>
#include <utility>

namespace filmsticking {

Index turn_to_sensors(Surface& surface, const std::vector<Index>& component,
                      const std::vector<Vec3>& viewpoints) {
  std::vector<double> front;
  for (Index t = 0; t < static_cast<Index>(component.size()); ++t) {
    const auto c = static_cast<std::size_t>(component[t]);
    if (c >= front.size()) front.resize(c + 1, 0);
    const Vec3 area = surface.area_vector2(t);
    for (int k = 0; k < 3; ++k) {
      const Index corner = surface.triangles[t][k];
      const Vec3 line = viewpoints[surface.site[corner]] - surface.positions[corner];
      if (line.allFinite()) front[c] += area.dot(line.stableNormalized());
    }
  }
  for (Index t = 0; t < static_cast<Index>(component.size()); ++t) {
    if (front[component[t]] < 0) std::swap(surface.triangles[t][1], surface.triangles[t][2]);
  }
  return static_cast<Index>(std::count_if(front.begin(), front.end(), [](double f) { return f < 0; }));
}

}  // namespace filmsticking
