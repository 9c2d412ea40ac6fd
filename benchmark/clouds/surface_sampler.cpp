// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_sampler.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

namespace filmsticking::bench {
namespace {

constexpr int kPatches = 5;
constexpr std::size_t kProbes = 50000;  // draws that measure how much a ball takes away

}  // namespace

SurfaceSampler::SurfaceSampler(const Mesh& mesh) : mesh_(mesh) {
  low_.setConstant(INFINITY);
  high_.setConstant(-INFINITY);
  for (const Point& p : mesh.positions) {
    const Vec3 q(p[0], p[1], p[2]);
    low_ = low_.cwiseMin(q);
    high_ = high_.cwiseMax(q);
  }
  area_up_to_.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = corner(t, 0);
    area_ += (corner(t, 1) - a).cross(corner(t, 2) - a).norm() / 2;
    area_up_to_.push_back(area_);
  }
  if (!(area_ > 0 && area_ < INFINITY)) throw std::invalid_argument("the mesh has no finite area");
}

Vec3 SurfaceSampler::corner(const Triangle& triangle, int k) const {
  const Point& p = mesh_.positions[triangle[k]];
  return {p[0], p[1], p[2]};
}

Sample SurfaceSampler::draw_from_whole(Random& random) const {
  const double at = random.uniform() * area_;
  const auto found = std::upper_bound(area_up_to_.begin(), area_up_to_.end(), at);
  const std::size_t face =
      std::min<std::size_t>(static_cast<std::size_t>(found - area_up_to_.begin()), area_up_to_.size() - 1);
  double u = random.uniform(), v = random.uniform();
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const Triangle& t = mesh_.triangles[face];
  const Vec3 a = corner(t, 0), e = corner(t, 1) - a, f = corner(t, 2) - a;
  return {a + e * u + f * v, e.cross(f).normalized()};
}

bool SurfaceSampler::is_missing(const Vec3& p) const {
  return std::any_of(holes_.begin(), holes_.end(), [&](const Ball& ball) {
    return (p - ball.centre).squaredNorm() <= ball.radius * ball.radius;
  });
}

void SurfaceSampler::take_patches_away(double share, Random& random) {
  if (!(share > 0)) return;
  std::vector<Vec3> left(kProbes);
  for (Vec3& p : left) p = draw_from_whole(random).position;
  const auto count = static_cast<std::size_t>(share / kPatches * kProbes);
  if (count == 0) return;
  for (int i = 0; i < kPatches; ++i) {
    const Vec3 centre = left[random.below(left.size())];
    const auto nearer = [&](const Vec3& a, const Vec3& b) {
      return (a - centre).squaredNorm() < (b - centre).squaredNorm();
    };
    std::nth_element(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(count - 1), left.end(), nearer);
    holes_.push_back({centre, (left[count - 1] - centre).norm()});
    left.erase(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(count));
  }
  missing_ = static_cast<double>(kPatches * count) / kProbes;
}

Sample SurfaceSampler::draw(Random& random) const {
  for (;;) {
    const Sample sample = draw_from_whole(random);
    if (!is_missing(sample.position)) return sample;
  }
}

}  // namespace filmsticking::bench
