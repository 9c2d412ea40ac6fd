// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "surface_distance.h"

namespace filmsticking::mesh_report {
namespace {

/// Points on a surface and the faces they are on.
struct Samples {
  std::vector<Vec3> points;
  std::vector<std::size_t> triangles;
};

/// Evenly spread over the area; empty for a surface without.
Samples sample(const Surface& surface, std::size_t count, std::uint64_t seed) {
  std::vector<double> area_up_to;
  double area = 0;
  for (std::size_t f = 0; f < surface.triangles.size(); ++f)
    area_up_to.push_back(area += surface.area_vector2(f).norm());
  Samples samples;
  if (!(area > 0) || !std::isfinite(area)) return samples;

  std::mt19937_64 engine(seed);
  // By hand: the standard leaves its distributions to the library, and the points must not depend on it.
  const auto uniform = [&engine] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  for (std::size_t i = 0; i < count; ++i) {
    const double at = uniform() * area, u = std::sqrt(uniform()), v = uniform();
    const auto face = std::upper_bound(area_up_to.begin(), area_up_to.end(), at);
    const auto f = std::min<std::size_t>(face - area_up_to.begin(), area_up_to.size() - 1);
    const Vec3 &a = surface.corner(f, 0), &b = surface.corner(f, 1), &c = surface.corner(f, 2);
    samples.points.push_back(a + (b - a) * (u * (1 - v)) + (c - a) * (u * v));
    samples.triangles.push_back(f);
  }
  return samples;
}

/// From the points on one surface to another.
struct OneWay {
  double mean = 0, largest = 0, near = 0, cosine = 0, opposed = 0;
};

OneWay one_way(const Surface& from, const Samples& samples, const Surface& to) {
  OneWay way;
  const std::vector<Nearest> nearest = SurfaceDistance(to).from(samples.points);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const double distance = nearest[i].distance;
    way.mean += distance;
    way.largest = std::max(way.largest, distance);
    way.near += distance < kNear ? 1 : 0;
    const double cosine = from.area_vector2(samples.triangles[i])
                              .normalized()
                              .dot(to.area_vector2(nearest[i].triangle).normalized());
    way.cosine += std::abs(cosine);
    way.opposed += cosine < 0 ? 1 : 0;
  }
  for (double* sum : {&way.mean, &way.near, &way.cosine, &way.opposed})
    *sum /= static_cast<double>(nearest.size());
  return way;
}

}  // namespace

std::optional<TruthDistances> truth_distances(const Surface& mesh, const Surface& truth,
                                              std::size_t samples) {
  const Frame frame = frame_of(truth.positions);
  if (!(frame.side > 0)) return std::nullopt;
  const Surface a = frame.to_unit(mesh), b = frame.to_unit(truth);
  const Samples on_a = sample(a, samples, 1), on_b = sample(b, samples, 2);
  if (on_a.points.empty() || on_b.points.empty()) return std::nullopt;
  const OneWay there = one_way(a, on_a, b), back = one_way(b, on_b, a);

  TruthDistances result;
  result.chamfer_e3 = 1e3 * (there.mean + back.mean) / 2;
  if (there.near + back.near > 0)
    result.f_score = 100 * 2 * there.near * back.near / (there.near + back.near);
  result.normal_consistency = 100 * (there.cosine + back.cosine) / 2;
  // A mesh that is turned over as a whole is right side out in itself.
  result.turned_over = 100 * std::min(there.opposed, 1 - there.opposed);
  result.hausdorff = std::max(there.largest, back.largest);
  return result;
}

}  // namespace filmsticking::mesh_report
