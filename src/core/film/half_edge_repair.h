// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "film/dual_complex.h"
#include "filmsticking/options.h"

namespace filmsticking {

/// What a repair did. None of it is a defect of the complex, which is closed by construction: the film does
/// not reach all points yet. A film that follows its sites evenly needs no repair.
struct RepairCounts {
  /// Orbits removed because their site keeps another one. The site's cell meets the film in several regions:
  /// the film spans a hole above the rim's points, or covers both sides of a thin part. Each removal takes
  /// two triangles at least, so this and `thin_regions` are at most half the triangles.
  std::int64_t surplus_regions = 0;
  /// Orbits removed because they had fewer than three neighbours: the cell barely touches the film.
  std::int64_t thin_regions = 0;
  /// Double edges resolved by a flip: two cells meet along the film twice, for example beside a surplus or
  /// thin region.
  std::int64_t flips = 0;
  /// Double edges resolved by opening the surface along both edges and closing the two rims: the film has a
  /// neck with two cells around it. Each raises the Euler characteristic by two, so it removes a handle or
  /// separates a component.
  std::int64_t cuts = 0;
  std::int64_t total() const { return surplus_regions + thin_regions + flips + cuts; }
};

/// Turns a closed complex into a simplicial 2-manifold in which every site has at most one ring of triangles
/// (paper, section 4.4). Returns triangles of sites. `positions`: per site. `choice`: which ring a site
/// keeps.
///
/// Every state in between is a closed oriented surface. Always ends, because of what the operations change:
///  - remove an orbit (surplus, or under three neighbours), fill the hole: two or more triangles fewer;
///  - flip one of two edges that join the same orbits: as many triangles, one double edge fewer;
///  - if no flip helps, open both edges and close the two rims: as many triangles, and the Euler
///  characteristic
///    rises by two. It is at most the number of triangles.
std::vector<Corners> repair_half_edges(const HalfEdgeComplex& complex, const std::vector<Vec3>& positions,
                                       RingChoice choice, RepairCounts& counts);

/// The paper's xi (section 4.4), the variation of normals around a ring: the sum of theta_j |n_j - mean|^2
/// over its triangles, with theta_j the angle at `centre`. `ring`: the neighbours in order.
double ring_roughness(const Vec3& centre, const std::vector<Vec3>& ring);

}  // namespace filmsticking
