// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/vec.h"

namespace filmsticking {

/// The film: a closed oriented 2-manifold. Its vertices are sites, or positions of no site: those of the
/// initial surface, and virtual sites that have left.
struct Surface {
  std::vector<Vec3> positions;
  std::vector<Index> site;  ///< per vertex: the site that stands there, or kNone
  std::vector<Corners> triangles;

  Vec3 corner(Index triangle, int k) const { return positions[triangles[triangle][k]]; }
  /// Normal to a triangle, outward, twice its area long.
  Vec3 area_vector2(Index triangle) const;
};

/// Six times the enclosed volume.
double signed_volume6(const Surface& surface);

/// A surface from triangles of sites, in the order of the triangles.
Surface unsorted_surface_of_sites(std::vector<Corners> triangles, const std::vector<Vec3>& sites);

/// A surface from triangles of sites, in a canonical order.
Surface surface_of_sites(std::vector<Corners> triangles, const std::vector<Vec3>& sites);

/// Number of sites among the surface's vertices with an id below `points`.
std::int64_t sites_on(const Surface& surface, std::size_t points);

}  // namespace filmsticking
