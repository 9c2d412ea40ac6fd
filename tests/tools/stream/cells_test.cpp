// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream/cells.h"

#include <gtest/gtest.h>

#include <unordered_set>

namespace filmsticking::stream {
namespace {

TEST(Cells, BeginAtMultiplesOfTheirWidth) {
  EXPECT_EQ(cell_of({0, 0.49, 0.5}, 0.5), (Cell{0, 0, 1}));
  EXPECT_EQ(cell_of({-0.01, -0.5, -0.51}, 0.5), (Cell{-1, -1, -2}));
  EXPECT_EQ(cell_of({1e300, 0, 0}, 1e-3)[0], 1e300 / 1e-3);  // nothing overflows
}

TEST(Cells, ZeroOfEitherSignIsOneCell) {
  const std::unordered_set<Cell, CellHash> cells = {cell_of({0.0, 0.0, 0.0}, 1),
                                                    cell_of({-0.0, -0.0, -0.0}, 1)};
  EXPECT_EQ(cells.size(), 1u);
}

}  // namespace
}  // namespace filmsticking::stream
