// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// An icosphere around all sites (paper, section 3). Its vertices are no sites. `sites`: around the origin.
Surface bounding_sphere(const std::vector<Vec3>& sites);

/// CGAL's alpha wrap of the sites; empty if CGAL finds none. `alpha`: radius of the ball that rolls outside,
/// in units of the box.
Surface alpha_wrap(const std::vector<Vec3>& sites, double alpha);

}  // namespace filmsticking
