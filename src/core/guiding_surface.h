// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vec.h"

namespace filmsticking {

/// The film: a closed oriented 2-manifold. Its vertices are sites, or positions of no site: those of the
/// initial surface, and virtual sites that have left.
struct GuidingSurface {
  std::vector<Vec3> positions;
  std::vector<Index> site;  ///< per vertex: the site that stands there, or kNone
  std::vector<Corners> triangles;

  Vec3 corner(Index triangle, int k) const { return positions[triangles[triangle][k]]; }
  /// Normal to a triangle, outward, twice its area long.
  Vec3 area_vector2(Index triangle) const;
};

/// An icosphere around the box [-0.5, 0.5]^3 that holds every site (paper, section 3).
GuidingSurface bounding_sphere(const std::vector<Vec3>& sites);

/// CGAL's alpha wrap of the sites: alpha is the radius of the ball that rolls outside, in units of the box.
/// Empty where CGAL finds none.
GuidingSurface alpha_wrap(const std::vector<Vec3>& sites, double alpha);

/// Six times the enclosed volume.
double signed_volume6(const GuidingSurface& surface);

}  // namespace filmsticking
