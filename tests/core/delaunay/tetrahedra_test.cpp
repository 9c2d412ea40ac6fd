// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/tetrahedra.h"

#include <gtest/gtest.h>

#include "delaunay/delaunay.h"
#include "support/power_cells.h"

namespace filmsticking {
namespace {

// Space and the outside together have no boundary: across a facet lies one that has it, too.
TEST(Tetrahedra, NeighboursPointBackAndInfiniteOnesCoverTheHull) {
  const Tetrahedra tets = delaunay_tetrahedra(test::random_sites(200, 7));
  int infinite = 0;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const auto own = static_cast<Index>(t);
    infinite += tets.infinite(own);
    for (const Index u : tets.neighbours[t]) {
      int back = 0;
      for (const Index w : tets.neighbours[u]) back += w == own;
      EXPECT_EQ(back, 1);
    }
  }
  EXPECT_GE(infinite, 4);
  EXPECT_LT(infinite, static_cast<int>(tets.size()));
}

}  // namespace
}  // namespace filmsticking
