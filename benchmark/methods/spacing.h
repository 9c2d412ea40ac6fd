// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::bench {

/// The mean distance to the 6 nearest points, averaged over the cloud: the length that methods with a radius
/// are given in units of.
double mean_spacing(const std::vector<Point>& points);

}  // namespace filmsticking::bench
