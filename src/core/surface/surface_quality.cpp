// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/euler.h"
#include "geometry/triangle_adjacency.h"

namespace filmsticking {

SurfaceQuality surface_quality(const Surface& surface, const SiteGeometry& geometry) {
  SurfaceQuality quality;
  double area = 0, sum = 0, whole = 0, wide = 0;
  std::vector<Vec3> vertex_normal(geometry.spacing.size(), Vec3::Zero());
  for (const Corners& t : surface.triangles) {
    const Vec3 &a = surface.positions[t[0]], &b = surface.positions[t[1]], &c = surface.positions[t[2]];
    const Vec3 normal = (b - a).cross(c - a);
    const double twice = normal.norm();
    if (!(twice > 0)) continue;
    double disagree = 0, spacing = 0, sample = 0;
    for (Index v : t) {
      vertex_normal[surface.site[v]] += normal;
      disagree += 1 - std::abs(normal.dot(geometry.normal[surface.site[v]])) / twice;
      spacing = std::max(spacing, geometry.spacing[surface.site[v]]);
      sample += geometry.spacing[surface.site[v]] * geometry.spacing[surface.site[v]] / 3;
    }
    // A bridge face weighs as much as one sample.
    const double weight = std::min(twice, 2 * spacing * spacing);
    area += weight;
    sum += weight * disagree / 3;
    whole += twice;
    quality.area += twice / 2 / sample;
    if ((a - b).norm() * (b - c).norm() * (c - a).norm() / (2 * twice) > 3 * spacing) {
      ++quality.wide_faces, wide += twice;
      quality.roughness += kAnyNormal * std::min(twice / 2 / sample, 1.0);
    } else {
      quality.roughness += std::min(twice / 2 / sample, 1.0) * std::log1p(disagree / 3 / kUsualDeviation);
    }
  }
  if (whole > 0) quality.bridging = wide / whole;
  if (area > 0) quality.disagreement = sum / area;
  std::vector<Index> vertex(geometry.spacing.size(), kNone);
  for (std::size_t v = 0; v < surface.site.size(); ++v) vertex[surface.site[v]] = static_cast<Index>(v);
  std::int64_t pairs = 0, opposed = 0;
  for (std::size_t v = 0; v < surface.site.size(); ++v)
    for (Index other : geometry.near[surface.site[v]]) {
      if (other == kNone || vertex[other] == kNone) continue;
      ++pairs;
      const Vec3 &m = vertex_normal[surface.site[v]], &n = vertex_normal[other],
                 way = surface.positions[vertex[other]] - surface.positions[v];
      const bool back_to_back = m.dot(way) < 0 && n.dot(way) > 0;
      opposed += m.dot(n) < 0 && !back_to_back;
    }
  if (pairs > 0) quality.conflict = static_cast<double>(opposed) / static_cast<double>(pairs);
  std::vector<Index> component;
  const std::vector<Index> twin =
      half_edge_twins(surface.triangles, static_cast<Index>(surface.positions.size()));
  const std::int64_t pieces = connected_components(twin, component);
  const std::int64_t rim = std::count(twin.begin(), twin.end(), kNone);
  const auto faces = static_cast<std::int64_t>(surface.triangles.size());
  const std::int64_t euler =
      euler_characteristic(static_cast<std::int64_t>(surface.positions.size()), faces, rim);
  quality.handles = std::max<std::int64_t>(0, genus(pieces, euler, boundary_loops(twin)));
  quality.complexity = pieces + std::max<std::int64_t>(0, genus(pieces, euler, 0));
  quality.off =
      static_cast<std::int64_t>(geometry.spacing.size()) - sites_on(surface, geometry.spacing.size());
  return quality;
}

}  // namespace filmsticking
