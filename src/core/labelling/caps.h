// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "labelling/labelling.h"

namespace filmsticking {

/// What closes tunnels that plugs leave open, as both sides of the wall are wide there: the tetrahedra on
/// either side of caps, smallest first. A cap is a connected set of facets, outside and narrower than
/// `radius` but between tetrahedra that are not, which the samples around it lie along, with more than a dent
/// beyond it.
std::vector<Move> caps(Labelling& labelling, const std::vector<Vec3>& sites, double radius);

}  // namespace filmsticking
