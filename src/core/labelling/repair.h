// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "labelling/labelling.h"

namespace filmsticking {

/// Makes the surface a 2-manifold from any labels, except at sites marked in `exempt` (empty: as the
/// labelling has them), and takes the census, which warp(), unfold(), reach() and mend() need. First it drops
/// islands; then moves lower the number of surplus pieces; last, where none does, it takes from the inside.
void repair(Labelling& labelling, std::vector<char> exempt = {});

/// The cheapest move at a singular site that lowers the number of surplus pieces, handles priced. Empty: none
/// does, or the visits are spent.
Move best_repair(Labelling& labelling, Index v);

}  // namespace filmsticking
