// SPDX-License-Identifier: GPL-3.0-or-later
// Values that stand for "no return", and points that no scanner has seen.
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <cstddef>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::io {

/// Whether each point lies absurdly far from all the rest, or is not finite: 10,000 times as far from the
/// median as two thirds of the points. None where two thirds are at one place.
std::vector<bool> absurdly_far(const std::vector<Point>& points);

/// Makes points not finite whose z is a value that programs write for a missing height (-9999, -32768 and the
/// like) and that lies farther below the others than these are high. Returns how many.
std::size_t mark_missing_heights(pcl::PCLPointCloud2& cloud);

}  // namespace filmsticking::io
