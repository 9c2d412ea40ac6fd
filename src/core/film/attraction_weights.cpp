// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/attraction_weights.h"

#include "geometry/nearest.h"
#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// Above 1, so that a site's cell crosses the film rather than touches it.
constexpr double kBeyond = 1.0001;

}  // namespace

std::vector<double> attraction_weights(const Surface& film, const std::vector<Vec3>& sites,
                                       const std::vector<Index>& off) {
  std::vector<double> weights(sites.size(), 0);
  if (film.triangles.empty()) return weights;
  const SurfaceTree tree(film);
  parallel_each(off.size(), [&](std::size_t k) {
    const Vec3& q = sites[off[k]];
    weights[off[k]] = kBeyond * (q - tree.nearest(q).point).squaredNorm();
  });
  return weights;
}

}  // namespace filmsticking
