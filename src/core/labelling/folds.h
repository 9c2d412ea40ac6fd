// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "labelling/labelling.h"

namespace filmsticking {

/// Does the surface fold back on itself at t: has it facets on both sides of t, and t is flat? Not where all
/// of the inside there is flat, as in a flat cloud or a sheet on a plane, which has no other surface.
bool folded(const Labelling& labelling, Index t);

/// By how many a move changes the number of folds.
int more_folds(Labelling& labelling, const Move& move);

}  // namespace filmsticking
