// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/euler.h"

#include <gtest/gtest.h>

namespace filmsticking {
namespace {

// A grid of n x m squares, each cut into two triangles, whose opposite sides may be joined.
struct Grid {
  std::int64_t vertices, faces, boundary_edges;
};

Grid sheet(std::int64_t n, std::int64_t m) { return {(n + 1) * (m + 1), 2 * n * m, 2 * (n + m)}; }
Grid tube(std::int64_t n, std::int64_t m) { return {n * (m + 1), 2 * n * m, 2 * n}; }
Grid torus(std::int64_t n, std::int64_t m) { return {n * m, 2 * n * m, 0}; }

std::int64_t euler(const Grid& grid) {
  return euler_characteristic(grid.vertices, grid.faces, grid.boundary_edges);
}

TEST(Euler, IsThatOfTheShapeWhateverTheTriangles) {
  for (std::int64_t n = 3; n < 9; ++n)
    for (std::int64_t m = 3; m < 9; ++m) {
      EXPECT_EQ(euler(sheet(n, m)), 1);
      EXPECT_EQ(euler(tube(n, m)), 0);
      EXPECT_EQ(euler(torus(n, m)), 0);
    }
  EXPECT_EQ(euler_characteristic(4, 4, 0), 2);    // a tetrahedron
  EXPECT_EQ(euler_characteristic(12, 20, 0), 2);  // an icosahedron
}

TEST(Euler, GenusCountsHandlesOfAllComponents) {
  EXPECT_EQ(genus(1, 2, 0), 0);  // a sphere
  EXPECT_EQ(genus(1, euler(torus(5, 7)), 0), 1);
  EXPECT_EQ(genus(1, euler(sheet(5, 7)), 1), 0);  // a disc has one boundary loop
  EXPECT_EQ(genus(1, euler(tube(5, 7)), 2), 0);
  EXPECT_EQ(genus(3, 2 + 0 + 0, 0), 2);  // a sphere and two tori
}

}  // namespace
}  // namespace filmsticking
