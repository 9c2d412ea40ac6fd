// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/layers.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "geometry/every_nth.h"
#include "geometry/nearest.h"
#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// Size of the sample, sites between two checks of the cancel, and neighbours to fit a quadric to.
constexpr std::size_t kLookedAt = 2000, kAtATime = 64, kAround = 40;
// Above this mean 1 - |cosine| between a site's normal and its faces', the surface disagrees there.
constexpr double kAgainst = 0.3;
// Noise that turns faces so far gives at least this SiteGeometry::variation.
constexpr double kNoise = 0.01;
// Kurtosis that separates two layers from noise. Measured medians: layers 1.5 (75 % below 1.75), noise 2.75
// (90 % above 2.2).
constexpr double kOneLayer = 2;

// Kurtosis of the points' distances from the quadric fitted to them.
double kurtosis(const std::vector<Vec3>& points) {
  const auto n = static_cast<double>(points.size());
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / n;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) spread += (p - mean) * (p - mean).transpose() / n;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const double size = std::sqrt(axes.eigenvalues()[2]);
  if (!(size > 0)) return 0;
  using Row = Eigen::Matrix<double, 6, 1>;
  std::vector<std::pair<Row, double>> rows;  // the quadric's terms, and the height
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Row right = Row::Zero();
  for (const Vec3& p : points) {
    const Vec3 q = axes.eigenvectors().transpose() * (p - mean) / size;  // the height first
    Row row;
    row << 1, q[1], q[2], q[1] * q[1], q[1] * q[2], q[2] * q[2];
    matrix += row * row.transpose(), right += q[0] * row;
    rows.emplace_back(row, q[0]);
  }
  matrix += 1e-9 * Eigen::Matrix<double, 6, 6>::Identity();  // points on a line leave some terms undetermined
  const Row terms = matrix.ldlt().solve(right);
  double second = 0, fourth = 0;
  for (const auto& [row, height] : rows) {
    const double off2 = std::pow(height - terms.dot(row), 2);
    second += off2 / n, fourth += off2 * off2 / n;
  }
  return second > 0 ? fourth / (second * second) : 0;
}

}  // namespace

double share_between_layers(const Surface& surface, const std::vector<Vec3>& places,
                            const SiteGeometry& geometry, const Cancel& cancel) {
  std::vector<double> against(surface.site.size(), 0), area(surface.site.size(), 0);
  for (Index t = 0; t < static_cast<Index>(surface.triangles.size()); ++t) {
    const Vec3 normal = surface.area_vector2(t);
    for (const Index v : surface.triangles[t]) {
      area[v] += normal.norm();
      against[v] += normal.norm() - std::abs(normal.dot(geometry.normal[surface.site[v]]));
    }
  }
  const PointTree tree(places);
  const EveryNth looked(surface.site.size(), kLookedAt);
  double between = 0;
  for (std::size_t begin = 0; begin < looked.size(); begin += kAtATime) {
    cancel();
    between += parallel_sum(std::min(looked.size(), begin + kAtATime) - begin, [&](std::size_t k) {
      const std::size_t v = looked[begin + k];
      if (against[v] <= kAgainst * area[v]) return 0;
      if (geometry.variation[surface.site[v]] < kNoise) return 1;
      std::vector<Vec3> around;
      for (const Index i : tree.nearest(surface.positions[v], kAround)) around.push_back(places[i]);
      return kurtosis(around) < kOneLayer ? 1 : 0;
    });
  }
  return looked.size() > 0 ? between / static_cast<double>(looked.size()) : 0;
}

}  // namespace filmsticking
