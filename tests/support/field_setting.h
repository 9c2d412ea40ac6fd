// SPDX-License-Identifier: GPL-3.0-or-later
// A cloud's tetrahedra and evidence, on which labels are tested.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "clouds.h"
#include "delaunay/delaunay.h"
#include "evidence/facet_evidence.h"
#include "film/film.h"
#include "geometry/triangle_adjacency.h"
#include "labelling/manifold_labels.h"
#include "labelling/surface_sheets.h"
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

inline Surface film_of(const FieldSetting& s, const std::vector<char>& inside) {
  return surface_of_sites(tetrahedral_boundary(s.mesh, inside), s.set.perturbed);
}

// V - E + F, or nothing where the surface is no closed manifold.
inline std::optional<std::int64_t> euler_if_manifold(const FieldSetting& s, const std::vector<char>& inside) {
  const Surface film = film_of(s, inside);
  const Index vertices = static_cast<Index>(film.positions.size());
  if (!film.triangles.empty() && !check_manifold(film.triangles, vertices).ok()) return {};
  return vertices - static_cast<std::int64_t>(film.triangles.size()) / 2;
}

// Labels as bad as they come: each tetrahedron at random.
inline std::vector<char> random_labels(const TetrahedralMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  std::vector<char> inside(mesh.size());
  for (std::size_t t = 0; t < inside.size(); ++t)
    inside[t] = !mesh.tets.infinite(static_cast<Index>(t)) && random.below(2);
  return inside;
}

// Inside are tetrahedra whose centres are `in` a shape.
template <class In>
std::vector<char> labels_where(const FieldSetting& s, const In& in) {
  std::vector<char> inside(s.mesh.size(), 0);
  for (std::size_t t = 0; t < inside.size(); ++t)
    if (!s.mesh.tets.infinite(static_cast<Index>(t))) inside[t] = in(s.set.to_input(s.centre(t)));
  return inside;
}

struct Topology {
  std::int64_t components = 0, handles = 0;
};

// Of a surface that is a closed manifold.
inline Topology topology(const FieldSetting& s, const std::vector<char>& inside) {
  const Surface film = film_of(s, inside);
  const Index vertices = static_cast<Index>(film.positions.size());
  std::vector<Index> twin, component;
  Topology result;
  if (film.triangles.empty() || !check_manifold(film.triangles, vertices, &twin).ok()) return result;
  result.components = connected_components(twin, component);
  result.handles = result.components - (vertices - static_cast<std::int64_t>(film.triangles.size()) / 2) / 2;
  return result;
}

}  // namespace filmsticking::test
