// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "labelling/labelling.h"

namespace filmsticking {

/// Removes folds and pinches at flat tetrahedra, as far as the topology allows. At a fold the surface has
/// facets on both sides of one; at a pinch, a facet on one side and, on the other, a site of the surface that
/// lies in that facet. After it a site that only a fold held is off the surface, and a pinched site belongs
/// to the sheet that it lies in. Needs a census.
void unfold(Labelling& labelling);

}  // namespace filmsticking
