// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::test {

/// fault(points), in a process of its own: a crash and a hang are faults too.
std::string isolated(const std::function<std::string(const std::vector<Point>&)>& fault,
                     const std::vector<Point>& points, int patience);

/// Leaves points out as long as the fault stays the same (delta debugging, Zeller and Hildebrandt 2002).
std::vector<Point> shrink(std::vector<Point> points,
                          const std::function<std::string(const std::vector<Point>&)>& fault);

/// A line for each point, with all digits.
void write_points(const std::string& path, const std::vector<Point>& points);

}  // namespace filmsticking::test
