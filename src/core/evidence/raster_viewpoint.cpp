// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/raster_viewpoint.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/every_nth.h"
#include "geometry/nearest.h"
#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// Size of the sample, and nearest pixels of each: the eight around it.
constexpr std::size_t kPixelsLookedAt = 10000, kPixelsAround = 8;
// Two of the eight are opposite if their midpoint is within this share of the shorter distance. The second
// share is tried if the first finds nothing.
constexpr double kOpposite[] = {0.125, 0.25};
// Sine of the bend of three pixels below which rounding and noise decide their plane. Below the least mean
// weight all places lie on a plane.
constexpr double kBend = 0.02, kSomeBend = 1e-5;
// Sine of the angle between a plane and the line of sight at which the plane's weight is halved, in the first
// and the last iteration. Of a raster the mean sine, clamped to kMiss, is below kMeet * kMiss.
constexpr double kFirstSlack = 0.5, kLastSlack = 0.01, kMiss = 0.05, kMeet = 0.7;
constexpr int kIterations = 40;
// Farthest viewpoint, in box sides.
constexpr double kFarthest = 30;

/// The plane of three pixels in a row.
struct RowPlane {
  Vec3 place, normal;  // the middle pixel's place, a unit normal
  double weight;       // 0 for collinear pixels, at most 1
};

// A plane that contains the surface's normal weighs most: it cuts the surface along the row.
std::vector<RowPlane> row_planes(const std::vector<Vec3>& places, const PointTree& tree,
                                 const SiteGeometry& geometry, double opposite) {
  const EveryNth looked(places.size(), kPixelsLookedAt);
  std::vector<std::vector<RowPlane>> found(looked.size());
  parallel_each(looked.size(), [&](std::size_t i) {
    const Vec3& middle = places[looked[i]];
    const std::vector<Index> near = tree.nearest(middle, kPixelsAround + 1);
    for (std::size_t j = 1; j < near.size(); ++j)
      for (std::size_t k = j + 1; k < near.size(); ++k) {
        const Vec3 a = places[near[j]] - middle, b = places[near[k]] - middle, normal = a.cross(b);
        const double shorter = std::min(a.norm(), b.norm()), size = normal.norm();
        if ((a + b).norm() > 2 * opposite * shorter || !(size > 0)) continue;
        const double bend = size / (a.norm() * b.norm()),
                     along = normal.dot(geometry.normal[looked[i]]) / size;
        found[i].push_back(
            {middle, normal / size, (1 - along * along) * bend * bend / (bend * bend + kBend * kBend)});
      }
  });
  std::vector<RowPlane> planes;
  for (const std::vector<RowPlane>& of_one : found) planes.insert(planes.end(), of_one.begin(), of_one.end());
  return planes;
}

// The sine of the angle between a plane and the line from its place to x.
double miss(const RowPlane& plane, const Vec3& x) {
  const Vec3 ray = x - plane.place;
  return std::abs(plane.normal.dot(ray)) / std::max(ray.norm(), 1e-300);
}

// One step of reweighted least squares: planes close to x weigh most.
Vec3 meeting_point(const std::vector<RowPlane>& planes, const Vec3& x, double slack) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  for (const RowPlane& plane : planes) {
    const double off = miss(plane, x) / slack;
    const double weight =
        plane.weight / ((1 + off * off) * std::max((x - plane.place).squaredNorm(), 1e-300));
    matrix += weight * plane.normal * plane.normal.transpose();
    right += weight * plane.normal.dot(plane.place) * plane.normal;
  }
  const double held = 1e-9 * matrix.trace();  // x stays where the planes do not determine it
  matrix += held * Eigen::Matrix3d::Identity();
  return matrix.ldlt().solve(right + held * x);
}

bool meet_at(const std::vector<RowPlane>& planes, const Vec3& x, double weight) {
  double missed = 0;
  for (const RowPlane& plane : planes) missed += plane.weight * std::min(1.0, miss(plane, x) / kMiss);
  return missed <= kMeet * weight;
}

std::optional<Vec3> common_point(const std::vector<RowPlane>& planes, const std::optional<Vec3>& guess) {
  double weight = 0;
  Vec3 x = Vec3::Zero();
  for (const RowPlane& plane : planes) weight += plane.weight;
  if (!(weight > kSomeBend * static_cast<double>(planes.size()))) return {};
  if (guess && meet_at(planes, *guess, weight)) return guess;
  for (const RowPlane& plane : planes) x += plane.weight / weight * plane.place;
  for (int i = 0; i < kIterations; ++i) {
    const double slack = kFirstSlack * std::pow(kLastSlack / kFirstSlack, i / (kIterations - 1.0));
    const Vec3 next = meeting_point(planes, x, slack);
    if (!next.allFinite() || next.norm() > kFarthest) return {};
    x = next;
  }
  if (!meet_at(planes, x, weight)) return {};
  return x;
}

}  // namespace

std::optional<Vec3> raster_viewpoint(const std::vector<Vec3>& places, const SiteGeometry& geometry,
                                     const std::optional<Vec3>& guess) {
  const PointTree tree(places);
  for (const double opposite : kOpposite)
    if (const auto found = common_point(row_planes(places, tree, geometry, opposite), guess)) return found;
  return {};
}

}  // namespace filmsticking
