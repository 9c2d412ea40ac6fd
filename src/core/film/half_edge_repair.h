// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "film/dual_complex.h"
#include "filmsticking/options.h"

namespace filmsticking {

/// What a repair had to do. None of it is a defect of the complex, which is closed by construction: a film
/// step cuts a film that is not on all points yet. A film that lies evenly on its sites needs nothing.
struct RepairCounts {
  /// Orbits removed because their site kept another one: its cell meets the film in several regions, as where
  /// the film spans a hole above the points of the rim, or lies on both sides of a thin part. Each takes two
  /// triangles along at least, so that with `thin_regions` they are at most half the triangles.
  std::int64_t surplus_regions = 0;
  /// Orbits removed because they had fewer than three neighbours: a cell that just touches the film.
  std::int64_t thin_regions = 0;
  /// Double edges resolved by a flip: two cells that meet along the film twice, as beside a surplus or thin
  /// region.
  std::int64_t flips = 0;
  /// Double edges resolved by cutting the surface open along both and closing it: a neck of the film of two
  /// cells around. Each raises the Euler characteristic by two, and so closes a handle or parts a piece; none
  /// on a film of simple topology.
  std::int64_t cuts = 0;
  std::int64_t total() const { return surplus_regions + thin_regions + flips + cuts; }
};

/// Makes a closed complex a simplicial 2-manifold in which every site has at most one ring of triangles
/// (paper, section 4.4). Result: triangles of sites.
///
/// Always ends, and every state in between is a closed oriented surface. Operations and what they lower:
///  - remove an orbit and fill its hole (surplus, or fewer than three neighbours): two triangles or more
///  fewer;
///  - flip one of two edges that join the same orbits: one double edge fewer, no triangle more;
///  - where no flip helps, cut along both edges and close the two rims: the Euler characteristic rises by
///    two, no triangle more, and it is at most the number of triangles.
std::vector<Corners> repair_half_edges(const HalfEdgeComplex& complex, const std::vector<Vec3>& positions,
                                       RingChoice choice, RepairCounts& counts);

/// The variation of normals around a ring (paper, section 4.4, xi): sum of theta_j |n_j - mean|^2 over its
/// triangles, theta_j the angle at `centre`; `ring` holds the neighbours in order.
double ring_roughness(const Vec3& centre, const std::vector<Vec3>& ring);

}  // namespace filmsticking
