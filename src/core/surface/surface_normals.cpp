// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_normals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/corner_angle.h"

namespace filmsticking {

std::vector<Vec3> surface_normals(const Surface& surface, std::vector<Vec3> otherwise) {
  std::vector<Vec3> sum(otherwise.size(), Vec3::Zero());
  for (const Corners& t : surface.triangles) {
    const Vec3 p[3] = {surface.positions[t[0]], surface.positions[t[1]], surface.positions[t[2]]};
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized();
    const double longest =
        std::max({(p[1] - p[0]).squaredNorm(), (p[2] - p[1]).squaredNorm(), (p[0] - p[2]).squaredNorm()});
    if (!(longest > 0)) continue;
    for (int k = 0; k < 3; ++k)
      sum[surface.site[t[k]]] += corner_angle(p[k], p[(k + 1) % 3], p[(k + 2) % 3]) / longest * normal;
  }
  for (std::size_t s = 0; s < sum.size(); ++s) {
    const double norm = sum[s].stableNorm();  // infinite for edges near the least double
    if (norm > 0 && std::isfinite(norm)) otherwise[s] = sum[s] / norm;
  }
  return otherwise;
}

}  // namespace filmsticking
