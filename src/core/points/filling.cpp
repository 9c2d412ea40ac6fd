// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/filling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/nearest.h"
#include "geometry/parallel.h"
#include "geometry/quantile.h"

namespace filmsticking {
namespace {

constexpr std::size_t kFewest = 200;
// Sites that are looked at, evenly from all.
constexpr std::size_t kLookedAt = 1000;
// Median variation (SiteGeometry). Measured: grids 0.27, random points in a ball 0.16; surfaces with noise of
// a spacing 0.14, and at most that for 12 models, thin walls
// among them, and 20 scans.
constexpr double kThick = 0.15;
// Median distance to the 96th neighbour over that to the 12th. 8^(1/2) = 2.8 on a surface, 8^(1/3) = 2 in a
// volume.
constexpr std::size_t kFar = 8 * kNeighbours;
constexpr double kCubic = 2.3;

}  // namespace

bool fills_volume(const std::vector<Vec3>& sites, const SiteGeometry& geometry) {
  if (sites.size() < kFewest) return false;
  std::vector<double> variation = geometry.variation;
  if (median(variation.begin(), variation.end()) < kThick) return false;
  const PointTree tree(sites);
  const std::size_t step = (sites.size() + kLookedAt - 1) / kLookedAt;
  std::vector<double> growth((sites.size() + step - 1) / step);
  parallel_each(growth.size(), [&](std::size_t i) {
    const Vec3& place = sites[i * step];
    const std::vector<Index> near = tree.nearest(place, kFar + 1);
    growth[i] = (sites[near.back()] - place).norm() / (sites[near[kNeighbours]] - place).norm();
  });
  return median(growth.begin(), growth.end()) < kCubic;
}

}  // namespace filmsticking
