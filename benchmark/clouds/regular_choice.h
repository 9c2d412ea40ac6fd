// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "random.h"
#include "sample.h"

namespace filmsticking::bench {

/// At most `count` of the candidates, each the nearest to the middle of a cell of a regular grid, whose cells
/// are as large as they can be for so many.
std::vector<Sample> choose_regularly(const std::vector<Sample>& candidates, std::size_t count, double area,
                                     const Vec3& low, Random& random);

}  // namespace filmsticking::bench
