// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/attraction_weights.h"

#include <algorithm>

#include "geometry/nearest.h"
#include "geometry/parallel.h"

namespace filmsticking {

std::size_t attraction_weights(const Surface& film, const std::vector<Vec3>& sites,
                               const std::vector<Index>& off, std::vector<double>& weights) {
  weights.assign(sites.size(), 0);
  std::vector<Vec3> off_positions;
  off_positions.reserve(off.size());
  for (Index q : off) off_positions.push_back(sites[q]);
  const PointTree off_tree(off_positions), vertex_tree(film.positions);
  const SurfaceTree surface_tree(film);
  parallel_each(off.size(), [&](std::size_t k) {
    const Vec3& q = off_positions[k];
    const Vec3 foot = surface_tree.nearest(q).point;
    const double d2 = (q - foot).squaredNorm();
    double in_front2 = 0, vertex2 = 0;
    off_tree.nearest(foot, &in_front2);
    if (in_front2 < d2 * (1 - 1e-9)) return;  // behind another site
    vertex_tree.nearest(q, &vertex2);
    weights[off[k]] = d2 + 0.1 * std::max(0.0, vertex2 - d2);
  });
  return static_cast<std::size_t>(
      std::count_if(weights.begin(), weights.end(), [](double w) { return w > 0; }));
}

}  // namespace filmsticking
