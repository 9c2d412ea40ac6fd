// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Weights that attract sites off the film (paper, section 4.2, case 2), per site; zero for all others. A
/// site at distance d from the film gets d^2, the least that reaches the film, and a little for rounding: so
/// the one that is nearest to it owns a part of it. `off`: the sites off the film.
std::vector<double> attraction_weights(const Surface& film, const std::vector<Vec3>& sites,
                                       const std::vector<Index>& off);

}  // namespace filmsticking
