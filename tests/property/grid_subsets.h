// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::test {

/// A set of points of the 3 x 3 x 3 grid: bit x + 3 y + 9 z.
using GridSet = std::uint32_t;

/// All sets of `least` to `most` points; with `classes`, one of each class of sets that turning and mirroring
/// the grid make of each other.
std::vector<GridSet> grid_sets(int least, int most, bool classes);

std::vector<Point> points_of(GridSet set);

/// Are they on one plane? Decided in whole numbers.
bool on_one_plane(GridSet set);

}  // namespace filmsticking::test
