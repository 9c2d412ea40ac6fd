// SPDX-License-Identifier: GPL-3.0-or-later
#include "ray_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace filmsticking::bench {
namespace {

/// Where a line is in a box, as distances; empty if the first is the larger.
std::pair<double, double> inside_of(const Box& box, const Vec3& eye, const Vec3& ray) {
  double enter = -INFINITY, leave = INFINITY;
  for (int k = 0; k < 3; ++k) {
    const double a = (box.low[k] - eye[k]) / ray[k], b = (box.high[k] - eye[k]) / ray[k];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return {enter, leave};
}

/// The way to where the union of the rooms ends.
double way_to_wall(const std::vector<Box>& rooms, const Vec3& eye, const Vec3& ray) {
  constexpr double kTouch = 1e-9;  // rooms that share a wall are one
  double way = 0;
  for (bool farther = true; farther;) {
    farther = false;
    for (const Box& room : rooms) {
      const auto [enter, leave] = inside_of(room, eye, ray);
      if (enter <= way + kTouch && leave > way + kTouch) way = leave, farther = true;
    }
  }
  return way;
}

double way_to_pole(const Pole& pole, const Vec3& eye, const Vec3& ray) {
  const Eigen::Vector2d from = eye.head<2>() - Eigen::Vector2d(pole.x, pole.y), along = ray.head<2>();
  const double a = along.squaredNorm(), b = from.dot(along),
               root = b * b - a * (from.squaredNorm() - pole.radius * pole.radius);
  if (!(root > 0)) return INFINITY;
  const double way = (-b - std::sqrt(root)) / a, z = eye.z() + way * ray.z();
  return way > 0 && z > 0 && z < pole.height ? way : INFINITY;
}

}  // namespace

double RayScene::first_hit(const Vec3& eye, const Vec3& ray) const {
  double way = rooms.empty() ? INFINITY : way_to_wall(rooms, eye, ray);
  if (ground && ray.z() < 0) way = std::min(way, -eye.z() / ray.z());
  for (const Box& box : boxes) {
    const auto [enter, leave] = inside_of(box, eye, ray);
    if (enter > 0 && enter < leave) way = std::min(way, enter);
  }
  for (const Pole& pole : poles) way = std::min(way, way_to_pole(pole, eye, ray));
  return way;
}

}  // namespace filmsticking::bench
