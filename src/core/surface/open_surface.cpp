// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/open_surface.h"

#include <algorithm>
#include <cmath>

#include "geometry/parallel.h"
#include "geometry/triangle_adjacency.h"

namespace filmsticking {
namespace {

// Gap of a face, in spacings. > 8: a bridge face.
constexpr float kWide = 8;
// > 4: a bridge face beside another. Alone it may be chance: the widest gap among n random points is about
// 2 sqrt(ln n / pi), 4.2 for a million.
constexpr float kStillWide = 4;

// The radius of the smallest enclosing circle: half the longest edge of an obtuse triangle.
double enclosing_radius(const Vec3& a, const Vec3& b, const Vec3& c) {
  double s[3] = {(b - c).squaredNorm(), (c - a).squaredNorm(), (a - b).squaredNorm()};
  std::sort(s, s + 3);
  if (s[0] + s[1] <= s[2]) return std::sqrt(s[2]) / 2;
  // Heron: 4 area = sqrt(4 s0 s1 - (s0 + s1 - s2)^2).
  const double four_areas = std::sqrt(std::max(0.0, 4 * s[0] * s[1] - std::pow(s[0] + s[1] - s[2], 2)));
  return std::sqrt(s[0] * s[1] * s[2]) / four_areas;
}

float face_gap(const Surface& surface, Corners t, const SiteGeometry& geometry) {
  // Start at the least site, so that rounding does not depend on the numbering.
  std::rotate(t.begin(),
              std::min_element(t.begin(), t.end(),
                               [&](Index a, Index b) { return surface.site[a] < surface.site[b]; }),
              t.end());
  double spacing = 0;
  for (Index v : t) spacing = std::max(spacing, geometry.spacing[surface.site[v]]);
  const double radius =
      enclosing_radius(surface.positions[t[0]], surface.positions[t[1]], surface.positions[t[2]]);
  return static_cast<float>(2 * radius / std::max(spacing, 1e-300));
}

std::vector<Corners> sites_of(const Surface& surface, const std::vector<char>& keep) {
  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    if (!keep[t]) continue;
    const Corners& c = surface.triangles[t];
    triangles.push_back({surface.site[c[0]], surface.site[c[1]], surface.site[c[2]]});
  }
  return triangles;
}

// The fans of faces around the vertices. A ring counts as a fan.
struct Fans {
  std::vector<Index> of;       // [half-edge]: the fan around its origin that holds its face
  std::vector<Index> largest;  // [vertex]: the first fan with most faces; kNone: no face
  std::vector<char> single;    // [vertex]: 1 if it has one fan
};

Fans find_fans(const Surface& surface) {
  const std::size_t vertices = surface.positions.size();
  const std::vector<Index> twin = half_edge_twins(surface.triangles, static_cast<Index>(vertices));
  Fans fans{std::vector<Index>(twin.size(), kNone), std::vector<Index>(vertices, kNone),
            std::vector<char>(vertices, 0)};
  std::vector<Index> most(vertices, 0);
  const auto back = [&](Index h) { return twin[h] == kNone ? kNone : next_in_face(twin[h]); };
  const auto forth = [&](Index h) { return twin[prev_in_face(h)]; };
  for (Index h = 0; h < static_cast<Index>(twin.size()); ++h) {
    if (fans.of[h] != kNone) continue;
    Index first = h;  // ends: the turn reaches an open end or the start
    for (Index g = back(h); g != kNone && g != h; g = back(g)) first = g;
    Index size = 0;
    for (Index g = first; g != kNone && fans.of[g] == kNone; g = forth(g)) fans.of[g] = h, ++size;
    const Index v = surface.triangles[h / 3][h % 3];
    fans.single[v] = fans.largest[v] == kNone;
    if (size > most[v]) fans.largest[v] = h, most[v] = size;
  }
  return fans;
}

// [face]: 1 if it is no bridge face.
std::vector<char> supported(const Surface& surface, const std::vector<float>& gaps) {
  const std::vector<Index> twin =
      half_edge_twins(surface.triangles, static_cast<Index>(surface.positions.size()));
  std::vector<char> keep(surface.triangles.size(), 1);
  std::vector<Index> removed;
  for (std::size_t t = 0; t < keep.size(); ++t)
    if (gaps[t] > kWide) keep[t] = 0, removed.push_back(static_cast<Index>(t));
  for (std::size_t next = 0; next < removed.size(); ++next)
    for (int k = 0; k < 3; ++k) {
      const Index other = twin[3 * removed[next] + k];
      if (other == kNone || !keep[other / 3] || gaps[other / 3] <= kStillWide) continue;
      keep[other / 3] = 0;
      removed.push_back(other / 3);
    }
  return keep;
}

}  // namespace

std::vector<float> face_gaps(const Surface& surface, const SiteGeometry& geometry) {
  std::vector<float> gaps(surface.triangles.size());
  parallel_each(gaps.size(),
                [&](std::size_t i) { gaps[i] = face_gap(surface, surface.triangles[i], geometry); });
  return gaps;
}

bool is_narrow(const Surface& surface, const Corners& face, const SiteGeometry& geometry) {
  return face_gap(surface, face, geometry) <= kStillWide;
}

std::vector<char> manifold_without_bridges(const std::vector<Corners>& triangles,
                                           const std::vector<Vec3>& sites, const SiteGeometry& geometry) {
  Surface surface = surface_of_sites(triangles, sites);
  surface = surface_of_sites(sites_of(surface, supported(surface, face_gaps(surface, geometry))), sites);
  const Fans fans = find_fans(surface);
  std::vector<char> clean(sites.size(), 0);
  for (std::size_t v = 0; v < surface.site.size(); ++v) clean[surface.site[v]] = fans.single[v];
  return clean;
}

void keep_faces(Surface& surface, std::vector<char> keep, const SiteGeometry& geometry) {
  std::vector<Vec3> sites(geometry.spacing.size());
  for (std::size_t v = 0; v < surface.site.size(); ++v) sites[surface.site[v]] = surface.positions[v];
  for (bool several = true; several;) {  // ends: a vertex with several fans loses faces
    surface = surface_of_sites(sites_of(surface, keep), sites);
    const Fans fans = find_fans(surface);
    several = std::count(fans.single.begin(), fans.single.end(), 0) > 0;
    keep.assign(surface.triangles.size(), 1);
    for (std::size_t h = 0; several && h < fans.of.size(); ++h)
      if (fans.of[h] != fans.largest[surface.triangles[h / 3][h % 3]]) keep[h / 3] = 0;
  }
}

void remove_bridges(Surface& surface, const SiteGeometry& geometry) {
  remove_bridges(surface, face_gaps(surface, geometry), geometry);
}

void remove_bridges(Surface& surface, const std::vector<float>& gaps, const SiteGeometry& geometry) {
  keep_faces(surface, supported(surface, gaps), geometry);
}

}  // namespace filmsticking
