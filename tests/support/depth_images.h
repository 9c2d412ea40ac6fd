// SPDX-License-Identifier: GPL-3.0-or-later
// Depth images of synthetic scenes, with faults of real cameras.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "clouds.h"
#include "geometry/vec.h"

namespace filmsticking::test {

/// The depth of the ray (x, y, 1) in the camera's frame; infinite if nothing is visible there.
using Depth = std::function<double(double x, double y)>;

/// A camera at the origin that looks along z: n by n pixels, from -1 to 1 at distance 1.
inline std::vector<Vec3> image_of(const Depth& depth, int n) {
  std::vector<Vec3> pixels;
  for (int v = 0; v < n; ++v)
    for (int u = 0; u < n; ++u) {
      const double x = 2 * (u + 0.5) / n - 1, y = 2 * (v + 0.5) / n - 1, z = depth(x, y);
      if (z < INFINITY) pixels.push_back(z * Vec3(x, y, 1));
    }
  return pixels;
}

inline double hills(double x, double y) { return 2 + 0.3 * std::sin(4 * x) * std::cos(3 * y) + 0.2 * x; }

/// A ball before a slanted wall. The wall bulges: a closed plane would be a plate without volume.
inline double ball_and_wall(double x, double y) {
  const double wall = (4 + 0.2 * (x * x + y * y)) / (1 + 0.3 * x + 0.2 * y), a = x * x + y * y + 1;
  const double d = 9 - a * (9 - 1);  // the ball: middle (0, 0, 3), radius 1
  return d > 0 ? (3 - std::sqrt(d)) / a : wall;
}

/// Quantised as by a structured-light camera: in equal steps of disparity.
inline Depth in_steps(const Depth& depth, double step) {
  return [=](double x, double y) { return 1 / (step * std::round(1 / (step * depth(x, y)))); };
}

/// The mean of each occupied cell of a grid, as by pcl::VoxelGrid.
inline std::vector<Vec3> thinned(const std::vector<Vec3>& places, double leaf) {
  std::map<std::array<double, 3>, std::pair<Vec3, int>> cells;
  for (const Vec3& p : places) {
    auto& cell =
        cells
            .emplace(std::array{std::floor(p.x() / leaf), std::floor(p.y() / leaf), std::floor(p.z() / leaf)},
                     std::pair(Vec3(Vec3::Zero()), 0))
            .first->second;
    cell.first += p, ++cell.second;
  }
  std::vector<Vec3> means;
  for (const auto& [key, cell] : cells) means.push_back(cell.first / cell.second);
  return means;
}

/// Adds Gaussian noise of this standard deviation along every axis.
inline std::vector<Vec3> noisy(std::vector<Vec3> places, double deviation, Random& random) {
  const auto normal = [&] {
    return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * M_PI * random.uniform());
  };
  for (Vec3& p : places) p += deviation * Vec3(normal(), normal(), normal());
  return places;
}

inline Eigen::Isometry3d random_pose(Random& random) {
  const Point axis = random.direction();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.rotate(Eigen::AngleAxisd(random.uniform(0, 3), Vec3(axis[0], axis[1], axis[2])));
  pose.pretranslate(Vec3(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)));
  return pose;
}

inline std::vector<Vec3> in_unit_box(const std::vector<Vec3>& places, const Eigen::Isometry3d& pose,
                                     Vec3& viewpoint) {
  Eigen::AlignedBox3d box;
  std::vector<Vec3> unit;
  for (const Vec3& p : places) unit.push_back(pose * p), box.extend(unit.back());
  const double side = box.sizes().maxCoeff();
  for (Vec3& p : unit) p = (p - box.center()) / side;
  viewpoint = (pose.translation() - box.center()) / side;
  return unit;
}

inline const std::pair<const char*, Depth> kScenes[] = {
    {"hills", hills},
    {"ball and wall", ball_and_wall},
    {"hills in steps", in_steps(hills, 0.004)},
    {"ball and wall in steps", in_steps(ball_and_wall, 0.003)}};

}  // namespace filmsticking::test
