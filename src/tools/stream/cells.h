// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of a cubic grid, for tables of cells.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

#include "filmsticking/types.h"

namespace filmsticking::stream {

/// A cell's place in the grid: whole numbers, as doubles because those do not overflow.
using Cell = std::array<double, 3>;

/// The cell that a point is in. `width`: of a cell, above zero.
inline Cell cell_of(const Point& p, double width) {
  return {std::floor(p[0] / width), std::floor(p[1] / width), std::floor(p[2] / width)};
}

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::size_t hash = 0;
    for (const double x : cell) hash = hash * 0x9e3779b97f4a7c15u + std::hash<double>()(x);
    return hash;
  }
};

}  // namespace filmsticking::stream
