// SPDX-License-Identifier: GPL-3.0-or-later
#include "sensor_scans.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "capsule.h"
#include "level_surface.h"
#include "sample.h"
#include "surface_sampler.h"

namespace filmsticking::bench {
namespace {

Point point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

Vec3 noise(double deviation, Random& random) {
  Vec3 off;
  for (double& x : off) x = deviation * random.gauss();
  return off;
}

// The torso: at height z its contour has the radius mean_radius(z) (1 + kLobes cos 2 angle).
constexpr double kHalfHeight = 1.2, kRadius = 0.7, kLobes = 0.3, kTaper = 0.15;

double mean_radius(double z) {
  const double u = z / kHalfHeight;
  return kRadius * std::sqrt(1 - u * u) * (1 + kTaper * u);
}

/// Points of a contour, evenly along it but for some jitter.
std::vector<Vec3> walk_contour(double z, double step, Random& random) {
  constexpr int kCorners = 2000;
  std::vector<Vec3> corners;
  std::vector<double> length_to = {0};
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2 * M_PI * i / kCorners, r = mean_radius(z) * (1 + kLobes * std::cos(2 * angle));
    corners.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    if (i > 0) length_to.push_back(length_to.back() + (corners[i] - corners[i - 1]).norm());
  }
  const double whole = length_to.back(), count = std::max(3.0, std::round(whole / step));
  const double phase = random.uniform();
  std::vector<Vec3> points;
  for (double k = 0; k < count; ++k) {
    constexpr double kJitter = 0.3;  // of the step
    const double at = std::fmod(k + phase + kJitter * random.uniform(), count) / count * whole;
    const auto next = std::upper_bound(length_to.begin() + 1, length_to.end() - 1, at);
    const auto i = static_cast<std::size_t>(next - length_to.begin());
    const double t = (at - length_to[i - 1]) / (length_to[i] - length_to[i - 1]);
    points.emplace_back((1 - t) * corners[i - 1] + t * corners[i]);
  }
  return points;
}

/// The way from `eye` inside a box around the origin to its wall.
double way_to_wall(const Vec3& half_sides, const Vec3& direction) {
  double nearest = INFINITY;
  for (int k = 0; k < 3; ++k)
    if (direction[k] != 0) nearest = std::min(nearest, half_sides[k] / std::abs(direction[k]));
  return nearest;
}

std::vector<Capsule> make_body(Random& random) {
  const double stride = 0.2 + 0.15 * random.uniform(), swing = 0.1 + 0.15 * random.uniform();
  return {{{0, 0, 0.98}, {0, 0, 1.34}, 0.16},                // torso
          {{0, 0, 1.40}, {0, 0, 1.60}, 0.06},                // neck
          {{0, 0, 1.62}, {0, 0, 1.68}, 0.12},                // head
          {{-0.14, 0, 1.40}, {-0.50, -swing, 0.98}, 0.045},  // arms
          {{0.14, 0, 1.40}, {0.50, swing, 0.98}, 0.045},     //
          {{-0.09, 0, 0.92}, {-0.14, stride, 0.07}, 0.07},   // legs
          {{0.09, 0, 0.92}, {0.14, -stride, 0.07}, 0.07}};
}

/// What a depth camera sees of a field that is a distance outside.
class Camera {
 public:
  Camera(const Field& field, const Vec3& eye, const Vec3& target)
      : field_(field), eye_(eye), ahead_((target - eye).normalized()) {
    right_ = ahead_.cross(Vec3::UnitZ()).normalized();
    up_ = right_.cross(ahead_);
    reach_ = 2 * (target - eye).norm();
  }

  /// The hits through pixels of this size, at distance 1, with noise along the rays.
  std::vector<Vec3> image(double pixel, double deviation, Random& random) const {
    constexpr double kExtent = 0.5;  // half the field of view, at distance 1
    const int half = static_cast<int>(kExtent / pixel);
    std::vector<Vec3> hits;
    for (int v = -half; v <= half; ++v)
      for (int u = -half; u <= half; ++u) {
        const Vec3 ray = (ahead_ + pixel * (u * right_ + v * up_)).normalized();
        const double depth = first_hit(ray);
        if (depth < reach_) hits.emplace_back(eye_ + (depth + deviation * random.gauss()) * ray);
      }
    return hits;
  }

 private:
  /// As far as the nearest surface is, no step along the ray can pass one.
  double first_hit(const Vec3& ray) const {
    constexpr double kOnSurface = 1e-6;
    double depth = 0;
    for (double step = 1; step > kOnSurface && depth < reach_; depth += step)
      step = field_(eye_ + depth * ray);
    return depth;
  }

  const Field& field_;
  Vec3 eye_, ahead_, right_, up_;
  double reach_;
};

}  // namespace

Scan make_slices(Random& random) {
  constexpr int kPlanes = 25;
  constexpr double kDistance = 2 * kHalfHeight / kPlanes;
  const double step = kDistance / (4 + 2 * random.uniform());
  Scan scan;
  for (int i = 0; i < kPlanes; ++i)
    for (const Vec3& p : walk_contour((i + 0.5) * kDistance - kHalfHeight, step, random))
      scan.points.push_back(point(p + noise(0.05 * step, random)));
  scan.size = 2 * kHalfHeight;
  // The integral of pi mean_radius(z)^2 (1 + kLobes^2 / 2).
  scan.volume = M_PI * (1 + kLobes * kLobes / 2) * kRadius * kRadius * kHalfHeight *
                (4.0 / 3 + kTaper * kTaper * 4 / 15);
  scan.tolerance = 0.15;
  scan.closed = scan.one_piece = true;
  return scan;
}

Scan make_rings(Random& random) {
  constexpr int kBeams = 16, kColumns = 360;
  constexpr double kUp = M_PI / 4, kNoise = 0.01;
  const Vec3 sides(10, 6, 3);
  Scan scan;
  for (int beam = 0; beam < kBeams; ++beam) {
    const double elevation = kUp * (2.0 * beam / (kBeams - 1) - 1), phase = random.uniform();
    for (int column = 0; column < kColumns; ++column) {
      const double around = 2 * M_PI * (column + phase) / kColumns;
      const Vec3 ray(std::cos(elevation) * std::cos(around), std::cos(elevation) * std::sin(around),
                     std::sin(elevation));
      scan.points.push_back(point((way_to_wall(sides / 2, ray) + kNoise * random.gauss()) * ray));
    }
  }
  scan.size = sides.maxCoeff();
  scan.volume = sides.prod();
  scan.tolerance = 0.15;
  scan.closed = true;
  return scan;
}

Scan make_figure(Random& random) {
  constexpr int kCameras = 3;
  constexpr double kPerCamera = 10000.0 / kCameras, kNoise = 0.002, kFirstPixel = 0.01;
  const std::vector<Capsule> body = make_body(random);
  const Field field = [&](const Vec3& p) {
    double nearest = INFINITY;
    for (const Capsule& part : body) nearest = std::min(nearest, part.distance(p));
    return nearest;
  };
  Scan scan;
  const double turn = random.uniform();
  for (int i = 0; i < kCameras; ++i) {
    const double angle = 2 * M_PI * (turn + static_cast<double>(i) / kCameras);
    const Camera camera(field, {2.5 * std::cos(angle), 2.5 * std::sin(angle), 1.2}, {0, 0, 0.9});
    const auto hits = static_cast<double>(camera.image(kFirstPixel, 0, random).size());
    for (const Vec3& p : camera.image(kFirstPixel * std::sqrt(hits / kPerCamera), kNoise, random))
      scan.points.push_back(point(p));
  }
  scan.size = 1.8;
  scan.area = SurfaceSampler(make_level_surface(field, {-0.7, -0.6, -0.1}, {0.7, 0.6, 1.9}, 0.01)).area();
  scan.tolerance = 0.15;
  scan.longest_edge = 0.5;
  scan.main_share = 0.95;
  return scan;
}

}  // namespace filmsticking::bench
