// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace filmsticking::mesh_report {

/// The length of a colour scale for distances: the first number 1, 2 or 5 times a power of ten that 99 % of
/// the distances above zero do not exceed, so that strays do not flatten the colours. 1 where all are zero.
double scale_length(std::vector<double> distances);

}  // namespace filmsticking::mesh_report
