// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "clouds/sample.h"
#include "command_line.h"
#include "filmsticking/types.h"

namespace filmsticking::bench {

/// The share of samples whose normal and true one point to the same side; those without a truth do not count.
double right_signs(const std::vector<Point>& normals, const std::vector<Sample>& samples);

/// Normals of ours, PCL and CGAL on every cloud: how many have the right sign. Prints a table, a row a kind
/// of cloud and method, means over the inputs; writes the CSV, if any, anew.
void compare_normals(const CommandLine& command);

}  // namespace filmsticking::bench
