// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/open_surface.h"

#include <algorithm>
#include <cmath>

#include "geometry/parallel.h"
#include "geometry/triangle_adjacency.h"

namespace filmsticking {
namespace {

// In spacings. The widest gap that chance leaves among n random points is about 2 sqrt(ln n / pi): 4.2 in a
// million, so that a face above the lower threshold is no bridge by itself.
constexpr float kWide = 8, kStillWide = 4;

// The radius of the smallest circle around a triangle: half the longest edge where the angle across is
// obtuse.
double enclosing_radius(const Vec3& a, const Vec3& b, const Vec3& c) {
  double s[3] = {(b - c).squaredNorm(), (c - a).squaredNorm(), (a - b).squaredNorm()};
  std::sort(s, s + 3);
  if (s[0] + s[1] <= s[2]) return std::sqrt(s[2]) / 2;
  // 4 area = sqrt(4 s0 s1 - (s0 + s1 - s2)^2) by Heron's formula
  const double four_areas = std::sqrt(std::max(0.0, 4 * s[0] * s[1] - std::pow(s[0] + s[1] - s[2], 2)));
  return std::sqrt(s[0] * s[1] * s[2]) / four_areas;
}

float face_gap(const Surface& film, Corners t, const SiteGeometry& geometry) {
  // The last bit is that of any other numbering.
  std::rotate(
      t.begin(),
      std::min_element(t.begin(), t.end(), [&](Index a, Index b) { return film.site[a] < film.site[b]; }),
      t.end());
  double spacing = 0;
  for (Index v : t) spacing = std::max(spacing, geometry.spacing[film.site[v]]);
  const double radius = enclosing_radius(film.positions[t[0]], film.positions[t[1]], film.positions[t[2]]);
  return static_cast<float>(2 * radius / std::max(spacing, 1e-300));
}

std::vector<Corners> sites_of(const Surface& film, const std::vector<char>& keep) {
  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    if (!keep[t]) continue;
    const Corners& c = film.triangles[t];
    triangles.push_back({film.site[c[0]], film.site[c[1]], film.site[c[2]]});
  }
  return triangles;
}

// The fans of faces around the vertices; a ring is one, too.
struct Fans {
  std::vector<Index> of;       // [half-edge]: the fan of its origin's that its face is in
  std::vector<Index> largest;  // [vertex]: the fan with most faces, the first of these; kNone: no face
  std::vector<char> single;    // [vertex]: it has one fan
};

Fans find_fans(const Surface& film) {
  const std::size_t vertices = film.positions.size();
  const std::vector<Index> twin = half_edge_twins(film.triangles, static_cast<Index>(vertices));
  Fans fans{std::vector<Index>(twin.size(), kNone), std::vector<Index>(vertices, kNone),
            std::vector<char>(vertices, 0)};
  std::vector<Index> most(vertices, 0);
  const auto back = [&](Index h) { return twin[h] == kNone ? kNone : next_in_face(twin[h]); };
  const auto forth = [&](Index h) { return twin[prev_in_face(h)]; };
  for (Index h = 0; h < static_cast<Index>(twin.size()); ++h) {
    if (fans.of[h] != kNone) continue;
    Index first = h;  // turning around a vertex comes to an open end or back to the start
    for (Index g = back(h); g != kNone && g != h; g = back(g)) first = g;
    Index size = 0;
    for (Index g = first; g != kNone && fans.of[g] == kNone; g = forth(g)) fans.of[g] = h, ++size;
    const Index v = film.triangles[h / 3][h % 3];
    fans.single[v] = fans.largest[v] == kNone;
    if (size > most[v]) fans.largest[v] = h, most[v] = size;
  }
  return fans;
}

// Which faces are no bridges.
std::vector<char> supported(const Surface& film, const std::vector<float>& gaps) {
  const std::vector<Index> twin = half_edge_twins(film.triangles, static_cast<Index>(film.positions.size()));
  std::vector<char> keep(film.triangles.size(), 1);
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

std::vector<float> face_gaps(const Surface& film, const SiteGeometry& geometry) {
  std::vector<float> gaps(film.triangles.size());
  parallel_each(gaps.size(), [&](std::size_t i) { gaps[i] = face_gap(film, film.triangles[i], geometry); });
  return gaps;
}

bool is_narrow(const Surface& film, const Corners& face, const SiteGeometry& geometry) {
  return face_gap(film, face, geometry) <= kStillWide;
}

std::vector<char> manifold_without_bridges(const std::vector<Corners>& triangles,
                                           const std::vector<Vec3>& sites, const SiteGeometry& geometry) {
  Surface film = surface_of_sites(triangles, sites);
  film = surface_of_sites(sites_of(film, supported(film, face_gaps(film, geometry))), sites);
  const Fans fans = find_fans(film);
  std::vector<char> clean(sites.size(), 0);
  for (std::size_t v = 0; v < film.site.size(); ++v) clean[film.site[v]] = fans.single[v];
  return clean;
}

void keep_faces(Surface& film, std::vector<char> keep, const SiteGeometry& geometry) {
  std::vector<Vec3> sites(geometry.spacing.size());
  for (std::size_t v = 0; v < film.site.size(); ++v) sites[film.site[v]] = film.positions[v];
  for (bool several = true; several;) {  // ends: a vertex with several fans loses faces
    film = surface_of_sites(sites_of(film, keep), sites);
    const Fans fans = find_fans(film);
    several = std::count(fans.single.begin(), fans.single.end(), 0) > 0;
    keep.assign(film.triangles.size(), 1);
    for (std::size_t h = 0; several && h < fans.of.size(); ++h)
      if (fans.of[h] != fans.largest[film.triangles[h / 3][h % 3]]) keep[h / 3] = 0;
  }
}

void remove_bridges(Surface& film, const SiteGeometry& geometry) {
  remove_bridges(film, face_gaps(film, geometry), geometry);
}

void remove_bridges(Surface& film, const std::vector<float>& gaps, const SiteGeometry& geometry) {
  keep_faces(film, supported(film, gaps), geometry);
}

}  // namespace filmsticking
