// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// An icosphere around the box [-0.5, 0.5]^3 that holds every site (paper, section 3).
Surface bounding_sphere(const std::vector<Vec3>& sites);

/// CGAL's alpha wrap of the sites: alpha is the radius of the ball that rolls outside, in units of the box.
/// Empty where CGAL finds none.
Surface alpha_wrap(const std::vector<Vec3>& sites, double alpha);

}  // namespace filmsticking
