// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Weights that attract sites off the film (paper, section 4.2); zero for all other sites. Returns the number
/// of positive weights. `off`: the sites off the film. `weights`: receives one per site.
///
/// A site q at distance d from the film gets a weight in the paper's interval (d^2, min |q-v|^2) over the
/// film's vertices v, a tenth of the way in. So q owns a part of the film and takes no vertex away. A site
/// behind another one gets none: some other site off the film is nearer to its nearest point on the film.
/// Without this rule the film would take in all layers of a shape at once.
std::size_t attraction_weights(const Surface& film, const std::vector<Vec3>& sites,
                               const std::vector<Index>& off, std::vector<double>& weights);

}  // namespace filmsticking
