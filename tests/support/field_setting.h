// SPDX-License-Identifier: GPL-3.0-or-later
// A cloud's tetrahedra and evidence, on which labels are tested.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "delaunay.h"
#include "field/manifold_labels.h"
#include "field/surface_sheets.h"
#include "film.h"
#include "site_set.h"
#include "triangle_adjacency.h"

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

inline GuidingSurface film_of(const FieldSetting& s, const std::vector<char>& inside) {
  return film_of_sites(tetrahedral_boundary(s.mesh, inside), s.set.perturbed);
}

// V - E + F, or nothing where the surface is no closed manifold.
inline std::optional<std::int64_t> euler_if_manifold(const FieldSetting& s, const std::vector<char>& inside) {
  const GuidingSurface film = film_of(s, inside);
  const Index vertices = static_cast<Index>(film.positions.size());
  if (!film.triangles.empty() && !check_manifold(film.triangles, vertices).ok()) return {};
  return vertices - static_cast<std::int64_t>(film.triangles.size()) / 2;
}

}  // namespace filmsticking::test
