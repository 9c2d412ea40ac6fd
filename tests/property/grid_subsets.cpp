// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_subsets.h"

#include <algorithm>
#include <array>

namespace filmsticking::test {
namespace {

using Cell = std::array<int, 3>;

constexpr int kCells = 27, kSymmetries = 48;

Cell cell(int bit) { return {bit % 3, bit / 3 % 3, bit / 9}; }

/// Where a symmetry takes a cell: the axes exchanged, and some of them mirrored.
Cell moved(Cell c, int symmetry) {
  std::array<int, 3> axes{0, 1, 2};
  for (int i = symmetry / 8; i > 0; --i) std::next_permutation(axes.begin(), axes.end());
  Cell to{};
  for (int k = 0; k < 3; ++k) to[k] = symmetry >> k & 1 ? 2 - c[axes[k]] : c[axes[k]];
  return to;
}

/// What each symmetry makes of nine cells at a time.
class Tables {
 public:
  Tables() : image_(kSymmetries) {
    for (int s = 0; s < kSymmetries; ++s)
      for (int part = 0; part < 3; ++part)
        for (GridSet bits = 0; bits < 512; ++bits) {
          GridSet to = 0;
          for (int i = 0; i < 9; ++i) {
            const Cell c = moved(cell(9 * part + i), s);
            if (bits >> i & 1) to |= GridSet{1} << (c[0] + 3 * c[1] + 9 * c[2]);
          }
          image_[s][part][bits] = to;
        }
  }

  GridSet image(GridSet set, int symmetry) const {
    const auto& table = image_[symmetry];
    return table[0][set & 511] | table[1][set >> 9 & 511] | table[2][set >> 18];
  }

 private:
  std::vector<std::array<std::array<GridSet, 512>, 3>> image_;
};

}  // namespace

std::vector<GridSet> grid_sets(int least, int most, bool classes) {
  const Tables tables;
  std::vector<GridSet> sets;
  for (int size = least; size <= most; ++size)
    for (GridSet set = (GridSet{1} << size) - 1; set < GridSet{1} << kCells;) {
      bool first = true;  // of its class
      for (int s = 1; classes && s < kSymmetries && first; ++s) first = tables.image(set, s) >= set;
      if (first) sets.push_back(set);
      // The next larger number with as many bits (Gosper).
      const GridSet low = set & (~set + 1), ripple = set + low;
      set = ripple | ((set ^ ripple) >> 2) / low;
    }
  return sets;
}

std::vector<Point> points_of(GridSet set) {
  std::vector<Point> points;
  for (int bit = 0; bit < kCells; ++bit)
    if (set >> bit & 1) {
      const Cell c = cell(bit);
      points.push_back({double(c[0]), double(c[1]), double(c[2])});
    }
  return points;
}

bool on_one_plane(GridSet set) {
  std::vector<Cell> cells;
  for (int bit = 0; bit < kCells; ++bit)
    if (set >> bit & 1) cells.push_back(cell(bit));
  for (std::size_t i = 1; i < cells.size(); ++i)
    for (std::size_t j = i + 1; j < cells.size(); ++j)
      for (std::size_t k = j + 1; k < cells.size(); ++k) {
        int m[3][3];
        for (int x = 0; x < 3; ++x) {
          m[0][x] = cells[i][x] - cells[0][x];
          m[1][x] = cells[j][x] - cells[0][x];
          m[2][x] = cells[k][x] - cells[0][x];
        }
        if (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) !=
            0)
          return false;
      }
  return true;
}

}  // namespace filmsticking::test
