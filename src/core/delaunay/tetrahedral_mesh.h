// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "delaunay/tetrahedra.h"
#include "points/site_set.h"

namespace filmsticking {

/// Corners of the facet opposite corner k, counter-clockwise seen from outside a positively oriented
/// tetrahedron.
constexpr int kFacet[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/// A thinner tetrahedron may be flat or inverted in exact coordinates. Above how far its corners were moved.
constexpr double kFlat = 4 * kPerturbation;

/// Delaunay tetrahedra and their geometry.
struct TetrahedralMesh {
  Tetrahedra tets;
  UnsetVector<std::array<Index, 4>> mirror;  ///< across facet k: the neighbour's facet, as 4 * tet + facet
  UnsetVector<Vec3> circumcentre;  ///< for an infinite one: the unit normal of its hull facet, into the hull
  UnsetVector<double> circumradius;  ///< for an infinite one: infinity
  /// For a tetrahedron that may be flat in exact coordinates, the set of its facets on one side, as bits;
  /// else 0. Facets on different sides overlap, facets on one side do not.
  UnsetVector<std::uint8_t> flat;

  std::size_t size() const { return tets.size(); }
};

/// Adds the geometry to tetrahedra of `sites`.
TetrahedralMesh make_tetrahedral_mesh(Tetrahedra tets, const std::vector<Vec3>& sites);

/// The facets between the tetrahedra marked inside and the others, counter-clockwise seen from outside.
/// Leaves out facets with the infinite vertex. `inside`: per tetrahedron.
std::vector<Corners> tetrahedral_boundary(const TetrahedralMesh& mesh, const std::vector<char>& inside);

}  // namespace filmsticking
