// SPDX-License-Identifier: GPL-3.0-or-later
#include "make_cloud.h"

#include <cmath>
#include <set>
#include <stdexcept>

#include "depth_view.h"
#include "mixed_density.h"
#include "sample_elimination.h"
#include "surface_sampler.h"

namespace filmsticking::bench {
namespace {

constexpr std::int64_t kMostPoints = 100'000'000;

void check(const CloudSpec& spec) {
  if (spec.points < 1 || spec.points > kMostPoints)
    throw std::invalid_argument("a cloud has from 1 to " + std::to_string(kMostPoints) + " points");
  if (!(spec.noise.deviation >= 0 && spec.noise.deviation <= 1))
    throw std::invalid_argument("the noise is a share from 0 to 1");
  if (!(spec.outliers >= 0 && spec.outliers <= 1))
    throw std::invalid_argument("the outliers are a share from 0 to 1");
  if (!(spec.missing >= 0 && spec.missing <= 0.9))
    throw std::invalid_argument("the missing surface is a share from 0 to 0.9");
  if (spec.sampling == Sampling::Vertices && spec.outliers + spec.missing > 0)
    throw std::invalid_argument("a mesh's vertices come without outliers and with nothing missing");
  if (is_depth(spec.sampling) && spec.missing > 0)
    throw std::invalid_argument("what a depth view does not see is missing, and nothing else");
}

std::vector<Sample> draw_samples(const SurfaceSampler& surface, Sampling sampling, std::size_t count,
                                 Random& random) {
  if (sampling == Sampling::MixedDensity) return sample_mixed_density(surface, count, random);
  const bool blue = sampling == Sampling::PoissonDisk;
  std::vector<Sample> samples(blue ? kCandidatesPerSample * count : count);
  for (Sample& sample : samples) sample = surface.draw(random);
  return blue ? eliminate_samples(samples, count, surface.area(), surface.low()) : samples;
}

/// Rounded to float. volatile: GCC 12 omits the rounding where it puts two such casts in one vector
/// instruction.
double rounded(double x) {
  const volatile float kept = static_cast<float>(x);
  return kept;
}

/// The distinct corners of faces, once each.
std::vector<Sample> vertex_samples(const Mesh& mesh) {
  std::set<Point> places;
  for (const Triangle& t : mesh.triangles)
    for (const std::int32_t v : t) {
      Point p = mesh.positions[static_cast<std::size_t>(v)];
      for (double& x : p) x = rounded(x) + 0.0;  // -0 is 0
      places.insert(p);
    }
  std::vector<Sample> samples;
  for (const Point& p : places) samples.push_back({Vec3(p[0], p[1], p[2]), Vec3::Zero()});
  return samples;
}

Point rounded(const Vec3& p) { return {rounded(p.x()), rounded(p.y()), rounded(p.z())}; }

}  // namespace

Mesh sampled_part(const Mesh& mesh, const CloudSpec& spec) {
  if (!is_depth(spec.sampling)) return mesh;
  const double spacing = std::sqrt(SurfaceSampler(mesh).area() / static_cast<double>(spec.points));
  Mesh part = visible_part(mesh, spec.seed, spacing);
  if (spec.sampling == Sampling::DepthFrame) {
    const Eigen::Isometry3d frame = depth_camera_frame(mesh, spec.seed);
    for (Point& p : part.positions) Eigen::Map<Vec3>(p.data()) = frame * Vec3(p[0], p[1], p[2]);
  }
  return part;
}

std::vector<Sample> make_samples(const Mesh& mesh, const CloudSpec& spec) {
  check(spec);
  SurfaceSampler surface(mesh);
  Random random(spec.seed);
  surface.take_patches_away(spec.missing, random);
  const auto outliers = static_cast<std::size_t>(spec.outliers * static_cast<double>(spec.points) + 0.5);
  const auto wanted = static_cast<std::size_t>(spec.points) - outliers;
  std::vector<Sample> samples;
  if (spec.sampling == Sampling::Vertices) {
    samples = vertex_samples(mesh);
  } else if (is_depth(spec.sampling)) {
    samples = sample_depth_view(mesh, wanted, spec.seed);
  } else if (wanted > 0) {
    samples = draw_samples(surface, spec.sampling, wanted, random);
  }
  const std::size_t total = samples.size() + outliers;

  const bool whole = !is_depth(spec.sampling);
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  if (spec.sampling == Sampling::DepthFrame) frame = depth_camera_frame(mesh, spec.seed);
  double sigma = spec.noise.deviation * surface.diagonal();
  if (sigma > 0 && spec.noise.in_spacings) {
    const double area = whole ? surface.area() : SurfaceSampler(sampled_part(mesh, spec)).area();
    sigma = spec.noise.deviation * std::sqrt(area / static_cast<double>(total));
  }
  const auto placed = [&](Vec3 p) {
    if (sigma > 0)
      for (int k = 0; k < 3; ++k) p[k] += sigma * random.gauss();
    return rounded(frame * p);
  };
  std::set<Point> seen;
  for (Sample& sample : samples) {
    Point p = placed(sample.position);
    // A mesh far from the origin has few floats: in the end a repeated point is better than no end.
    for (int i = 0; whole && i < 100 && seen.count(p) > 0; ++i) {
      const Sample other = surface.draw(random);
      sample.normal = other.normal;
      p = placed(other.position);
    }
    seen.insert(p);
    sample = {Vec3(p[0], p[1], p[2]), frame.linear() * sample.normal};
  }
  while (samples.size() < total) {
    Vec3 p;
    for (int k = 0; k < 3; ++k)
      p[k] = surface.low()[k] + random.uniform() * (surface.high()[k] - surface.low()[k]);
    const Point place = rounded(frame * p);
    samples.push_back({Vec3(place[0], place[1], place[2]), Vec3::Zero()});
  }
  random.shuffle(samples);
  return samples;
}

std::vector<Point> make_cloud(const Mesh& mesh, const CloudSpec& spec) {
  std::vector<Point> points;
  for (const Sample& sample : make_samples(mesh, spec))
    points.push_back({sample.position.x(), sample.position.y(), sample.position.z()});
  return points;
}

}  // namespace filmsticking::bench
