// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::test {

/// A small cloud of the sort that breaks geometry, 0 to 2,000 points: several of lines, planes, grids,
/// spheres, circles, clusters and noise, at scales from 1e-30 to 1e30 and beyond, with huge offsets, repeated
/// and nearly repeated points, denormal numbers, NaN and infinities. The same seed gives the same cloud.
std::vector<Point> nasty_cloud(std::uint64_t seed);

/// A cloud on which moving by a power of two is exact: multiples of 2^-20 within 1 of the origin; 0 to 300
/// points of the same shapes, all finite.
std::vector<Point> dyadic_cloud(std::uint64_t seed);

}  // namespace filmsticking::test
