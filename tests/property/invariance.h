// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::test {

/// Empty if these give the same mesh on the same points as reconstruct(points): another run, other numbers of
/// threads, another order, and a uniform scale of a power of two (exact while nothing overflows or becomes
/// denormal: the caller sees to that). Else which does not.
std::string invariance_fault(const std::vector<Point>& points, std::uint64_t seed);

/// The same for moves by powers of two of a dyadic_cloud().
std::string move_fault(const std::vector<Point>& points);

/// The same for turns of a dyadic_cloud() by 90 degrees around the axes. Nothing is tried with a cloud that
/// one of them maps onto itself: its mesh has to break the symmetry.
std::string turn_fault(const std::vector<Point>& points);

}  // namespace filmsticking::test
