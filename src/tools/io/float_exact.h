// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::io {

/// Whether all coordinates keep their value as single-precision numbers.
inline bool float_exact(const std::vector<Point>& positions) {
  return std::all_of(positions.begin(), positions.end(), [](const Point& p) {
    return std::all_of(p.begin(), p.end(), [](double x) {
      // A finite value past the range of float must not be cast.
      return std::isnan(x) || std::isinf(x) || (std::abs(x) < 3e38 && static_cast<float>(x) == x);
    });
  });
}

}  // namespace filmsticking::io
