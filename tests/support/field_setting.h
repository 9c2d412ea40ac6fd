// SPDX-License-Identifier: GPL-3.0-or-later
// A cloud's tetrahedra and evidence, and labels on them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "clouds.h"
#include "delaunay/delaunay.h"
#include "evidence/facet_evidence.h"
#include "film/film.h"
#include "geometry/triangle_adjacency.h"
#include "labelling/label_islands.h"
#include "labelling/labelling.h"
#include "points/site_set.h"

namespace filmsticking::test {

struct FieldSetting {
  SiteSet set;
  TetrahedralMesh mesh;
  SiteGeometry geometry;
  FacetEvidence evidence;
  explicit FieldSetting(const std::vector<Point>& points)
      : set(make_site_set(points)),
        mesh(make_tetrahedral_mesh(delaunay_tetrahedra(set.perturbed), set.perturbed)),
        geometry(site_geometry(set.perturbed)),
        evidence(facet_evidence(mesh, set.perturbed, geometry)) {}
  bool infinite(std::size_t t) const { return mesh.tets.infinite(static_cast<Index>(t)); }
  Vec3 centre(std::size_t t) const {
    Vec3 c = Vec3::Zero();
    for (Index i : mesh.tets.corners[t]) c += set.perturbed[i] / 4;
    return c;
  }
};

inline LabelCosts costs_of(const FieldSetting& s) {
  LabelCosts costs{s.evidence.cost, std::vector<double>(s.mesh.size(), 0), {}};
  for (const double spacing : s.geometry.spacing) costs.off.push_back(5 * spacing * spacing);
  return costs;
}

/// Labels, and the state that the functions of labelling/ change. `s` must outlive it.
struct LabelSetting {
  const FieldSetting& s;
  LabelCosts costs;
  std::vector<char> inside;
  Labelling labelling;
  LabelSetting(const FieldSetting& setting, std::vector<char> labels)
      : s(setting),
        costs(costs_of(setting)),
        inside(std::move(labels)),
        labelling(s.mesh, s.geometry, costs, inside) {}
  LabelSetting(const LabelSetting&) = delete;
  LabelSetting& operator=(const LabelSetting&) = delete;
};

inline Surface surface_of(const FieldSetting& s, const std::vector<char>& inside) {
  return surface_of_sites(tetrahedral_boundary(s.mesh, inside), s.set.perturbed);
}

// V - E + F, or nothing where the surface is no closed manifold.
inline std::optional<std::int64_t> euler_if_manifold(const FieldSetting& s, const std::vector<char>& inside) {
  const Surface surface = surface_of(s, inside);
  const Index vertices = static_cast<Index>(surface.positions.size());
  if (!surface.triangles.empty() && !check_manifold(surface.triangles, vertices).ok()) return {};
  return vertices - static_cast<std::int64_t>(surface.triangles.size()) / 2;
}

// Labels as bad as they come: each tetrahedron at random, inside in `of` cases of `of + 1`.
inline std::vector<char> random_labels(const TetrahedralMesh& mesh, std::uint64_t seed, int of = 1) {
  Random random(seed);
  std::vector<char> inside(mesh.size());
  for (std::size_t t = 0; t < inside.size(); ++t)
    inside[t] = !mesh.tets.infinite(static_cast<Index>(t)) && random.below(of + 1) > 0;
  return inside;
}

// Inside are tetrahedra whose centres are `in` a shape.
template <class In>
std::vector<char> labels_where(const FieldSetting& s, const In& in) {
  std::vector<char> inside(s.mesh.size(), 0);
  for (std::size_t t = 0; t < inside.size(); ++t)
    if (!s.infinite(t)) inside[t] = in(s.set.to_input(s.centre(t)));
  return inside;
}

// A connected part of one label, of up to `most` finite tetrahedra, from a random one.
inline Move random_part(const FieldSetting& s, const std::vector<char>& inside, Random& random, int most) {
  Index start;
  do start = random.below(static_cast<int>(s.mesh.size()));
  while (s.mesh.tets.infinite(start));
  Move part{start};
  std::vector<char> met(s.mesh.size(), 0);
  met[start] = 1;
  for (std::size_t i = 0; i < part.size(); ++i)
    for (Index u : s.mesh.tets.neighbours[part[i]]) {
      if (static_cast<int>(part.size()) >= most || met[u] || s.mesh.tets.infinite(u) ||
          inside[u] != inside[start] || random.below(2))
        continue;
      met[u] = 1;
      part.push_back(u);
    }
  return part;
}

inline std::int64_t differences(const std::vector<char>& a, const std::vector<char>& b) {
  std::int64_t count = 0;
  for (std::size_t t = 0; t < a.size(); ++t) count += a[t] != b[t];
  return count;
}

struct Topology {
  std::int64_t components = 0, handles = 0;
};

// Of a surface that is a closed manifold.
inline Topology topology(const FieldSetting& s, const std::vector<char>& inside) {
  const Surface surface = surface_of(s, inside);
  const Index vertices = static_cast<Index>(surface.positions.size());
  std::vector<Index> twin, component;
  Topology result;
  if (surface.triangles.empty() || !check_manifold(surface.triangles, vertices, &twin).ok()) return result;
  result.components = connected_components(twin, component);
  result.handles =
      result.components - (vertices - static_cast<std::int64_t>(surface.triangles.size()) / 2) / 2;
  return result;
}

// Pieces of the tetrahedra at each site, joined through facets at the site, searched one by one.
inline std::vector<Census> censuses_by_hand(const TetrahedralMesh& mesh, const std::vector<char>& inside,
                                            std::size_t sites) {
  std::vector<std::vector<Index>> stars(sites);
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (const Index v : mesh.tets.corners[t])
      if (v != kNone) stars[v].push_back(static_cast<Index>(t));
  std::vector<Census> result(sites);
  std::vector<char> met(mesh.size(), 1);
  for (std::size_t v = 0; v < sites; ++v) {
    for (const Index t : stars[v]) met[t] = 0;
    for (const Index start : stars[v]) {
      if (met[start]) continue;
      ++(inside[start] ? result[v].inside : result[v].outside);
      std::vector<Index> stack{start};
      for (met[start] = 1; !stack.empty();) {
        const Index t = stack.back();
        stack.pop_back();
        for (int k = 0; k < 4; ++k) {
          const Index u = mesh.tets.neighbours[t][k];
          if (mesh.tets.corners[t][k] == static_cast<Index>(v) || met[u] || inside[u] != inside[t]) continue;
          met[u] = 1;
          stack.push_back(u);
        }
      }
    }
  }
  return result;
}

// A wall with a bend, as flat ones have flat tetrahedra beside them: its samples, without those of a round
// gap in the middle of both sides, and what is inside, but for a bore in the gap.
struct BentWall {
  double thickness, gap, bore;
  static double bend(double x, double y) { return 0.2 * (x * x + 1.3 * y * y); }
  static double from_middle(const Point& p) { return std::hypot(p[0] - 0.5, p[1] - 0.5); }

  std::vector<Point> samples(int n, std::uint64_t seed) const {
    std::vector<Point> points;
    for (Point p : box(n, seed, {1, 1, thickness})) {
      if (from_middle(p) < gap) continue;
      p[2] += bend(p[0], p[1]);
      points.push_back(p);
    }
    return points;
  }
  bool in(const Point& p) const {
    const double z = p[2] - bend(p[0], p[1]);
    return z > 0 && z < thickness && from_middle(p) > bore;
  }
};

// A ball of radius 1 with a round cavity, and a tube from there to outside unless its radius is 0; about 0.08
// apart.
inline std::vector<Point> ball_with_cavity(std::uint64_t seed, double cavity, double tube) {
  std::vector<Point> points;
  const auto add = [&](const Point& p) {
    if (std::hypot(p[0], p[1]) > tube || p[2] < 0) points.push_back(p);
  };
  for (const Point& p : sphere(2000, seed)) add(p);
  for (const Point& p : sphere(static_cast<int>(2000 * cavity * cavity), seed + 1000))
    add({cavity * p[0], cavity * p[1], cavity * p[2]});
  Random random(seed);
  const int around = static_cast<int>(2000 * tube * (1 - cavity) / 2);
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * M_PI * random.uniform(), z = cavity + (1 - cavity) * random.uniform();
    points.push_back({tube * std::cos(angle), tube * std::sin(angle), z});
  }
  return points;
}

// Two ellipsoids in a row along x, the second around `x0`: their samples, and what is inside.
struct TwoEllipsoids {
  double x0;
  std::vector<Point> samples(std::uint64_t seed) const {
    std::vector<Point> points = ellipsoid(1500, seed, 0);
    for (const Point& p : ellipsoid(1500, seed + 100, x0)) points.push_back(p);
    return points;
  }
  bool in(const Point& p) const {
    const auto one = [&](double x) {
      return std::pow(p[0] - x, 2) + std::pow(p[1] / 0.8, 2) + std::pow(p[2] / 0.6, 2) < 1;
    };
    return one(0) || one(x0);
  }
};

}  // namespace filmsticking::test
