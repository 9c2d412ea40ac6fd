// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/even_units.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>

#include "geometry/nearest.h"
#include "geometry/parallel.h"
#include "geometry/quantile.h"

namespace filmsticking {
namespace {

constexpr std::size_t kFewestPlaces = 16;
// Height over width of a box, above which the heights may have another unit. Terrain is flatter.
constexpr double kHigh = 10;
// Median slope between neighbours on the map, above which they have: 72 degrees.
constexpr double kSteep = 3;
// Median slope that they get: that of steep terrain.
constexpr double kUsualSlope = 0.5;
// Points that are looked at, evenly from all, and neighbours of each.
constexpr std::size_t kPlacesLookedAt = 1000, kNearPlaces = 6;

double median_slope(const std::vector<Vec3>& map, const std::vector<double>& height) {
  const PointTree tree(map);
  const std::size_t step = (map.size() + kPlacesLookedAt - 1) / kPlacesLookedAt;
  std::vector<double> slope((map.size() + step - 1) / step);
  parallel_each(slope.size(), [&](std::size_t i) {
    double run = 0, rise = 0;
    for (const Index other : tree.nearest(map[i * step], kNearPlaces + 1)) {
      run += (map[other] - map[i * step]).norm();
      rise += std::abs(height[other] - height[i * step]);
    }
    slope[i] = run > 0 ? rise / run : 0;
  });
  return median(slope.begin(), slope.end());
}

}  // namespace

std::vector<Point> in_even_units(const PointsView& points, const Vec3& direction) {
  const Vec3 up = direction.stableNormalized();
  const auto each_finite = [&](const auto& visit) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 p(points[i][0], points[i][1], points[i][2]);
      if (p.allFinite()) visit(Vec3(p - up.dot(p) * up), up.dot(p));
    }
  };
  Eigen::AlignedBox3d wide;
  Eigen::AlignedBox<double, 1> high;
  std::size_t finite = 0;
  each_finite([&](const Vec3& place, double h) {
    ++finite, wide.extend(place), high.extend(Eigen::Matrix<double, 1, 1>(h));
  });
  if (finite < kFewestPlaces || !(high.sizes()[0] > kHigh * wide.diagonal().norm())) return {};

  std::vector<Vec3> map;
  std::vector<double> height;
  each_finite([&](const Vec3& place, double h) { map.push_back(place), height.push_back(h); });
  const double slope = median_slope(map, height);
  if (!(slope > kSteep) || !std::isfinite(slope)) return {};
  std::vector<Point> even(points.size());
  parallel_each(even.size(), [&](std::size_t i) {
    const Vec3 p(points[i][0], points[i][1], points[i][2]);
    const Vec3 q = p + (kUsualSlope / slope - 1) * up.dot(p) * up;
    even[i] = {q.x(), q.y(), q.z()};
  });
  return even;
}

}  // namespace filmsticking
