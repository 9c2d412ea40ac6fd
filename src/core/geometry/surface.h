// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/vec.h"

namespace filmsticking {

/// An oriented triangle surface; usually a 2-manifold, with or without boundary. Vertices are sites, except
/// those of a film that has not reached a site there.
struct Surface {
  std::vector<Vec3> positions;
  std::vector<Index> site;  ///< [vertex]: its site, or kNone
  std::vector<Corners> triangles;

  Vec3 corner(Index triangle, int k) const { return positions[triangles[triangle][k]]; }
  /// The outward normal of a triangle, twice its area long.
  Vec3 area_vector2(Index triangle) const;
};

/// A surface from triangles of sites, which keep their order. Vertices are sorted by site.
Surface unsorted_surface_of_sites(std::vector<Corners> triangles, const std::vector<Vec3>& sites);

/// The same with triangles sorted, each from its least corner: independent of the order given.
Surface surface_of_sites(std::vector<Corners> triangles, const std::vector<Vec3>& sites);

/// The number of vertices with a site below `points`.
std::int64_t sites_on(const Surface& surface, std::size_t points);

}  // namespace filmsticking
