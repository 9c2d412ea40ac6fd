// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Weights that attract sites off the film (paper, section 4.2), zero for all others. A site at distance d
/// from the film gets a weight in the paper's interval (d^2, min |q-v|^2) over the film's vertices v, a tenth
/// into it, so that it owns a piece of the film and takes no vertex away. Only sites that are not behind
/// another one get it: those whose nearest film point has no other such site nearer. Without that rule all
/// layers of a shape are pasted onto the film at once.
/// `off`: the sites off the film. Returns the number of weighted sites.
std::size_t attraction_weights(const Surface& film, const std::vector<Vec3>& sites,
                               const std::vector<Index>& off, std::vector<double>& weights);

}  // namespace filmsticking
