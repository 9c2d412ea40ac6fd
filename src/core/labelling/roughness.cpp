// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/roughness.h"

#include <algorithm>

#include "geometry/quantile.h"

namespace filmsticking {
namespace {

// 1 less the median cosine from which a surface is rough: that of noise of half the spacing.
constexpr double kRough = 0.2;

}  // namespace

double roughness(const Labelling& labelling, const std::vector<Vec3>& sites) {
  const std::vector<Corners> facets = tetrahedral_boundary(labelling.mesh(), labelling.labels());
  std::vector<Vec3> normal(facets.size()), mean(sites.size(), Vec3::Zero());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const Vec3& o = sites[facets[i][0]];
    normal[i] = (sites[facets[i][1]] - o).cross(sites[facets[i][2]] - o);
    for (Index v : facets[i]) mean[v] += normal[i];
  }
  std::vector<double> cosines;
  for (std::size_t i = 0; i < facets.size(); ++i)
    for (Index v : facets[i])
      if (const double size = normal[i].norm() * mean[v].norm(); size > 0)
        cosines.push_back(normal[i].dot(mean[v]) / size);
  if (cosines.empty()) return 0;
  return std::clamp((1 - median(cosines.begin(), cosines.end())) / kRough, 0.0, 1.0);
}

}  // namespace filmsticking
