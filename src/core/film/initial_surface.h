// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// An icosphere around all sites (paper, section 3). Its vertices are no sites. `sites`: around the origin.
Surface bounding_sphere(const std::vector<Vec3>& sites);

/// Tells which places a closed oriented surface contains, by its winding number; may be asked from any
/// thread. Nothing is inside a surface without faces. By hand: CGAL's Side_of_triangle_mesh casts rays until
/// one meets no degenerate face, which a surface that a caller hands in may not allow.
std::function<bool(const Vec3&)> enclosure(const Surface& surface);

/// CGAL's alpha wrap of the sites; empty if CGAL finds none. `alpha`: radius of the ball that rolls outside,
/// in units of the box.
Surface alpha_wrap(const std::vector<Vec3>& sites, double alpha);

}  // namespace filmsticking
