// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/rims.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

using Rims = std::vector<Rim>;

TEST(Rims, ALoopStartsAtItsLeastVertexInItsDirection) {
  EXPECT_EQ(find_rims({{5, 3}, {3, 9}, {9, 5}}), (Rims{{3, 9, 5}}));
  EXPECT_EQ(find_rims({}), Rims{});
}

TEST(Rims, ALoopThatTouchesItselfIsTwo) {
  EXPECT_EQ(find_rims({{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 2}}), (Rims{{0, 1, 2}, {2, 3, 4}}));
}

TEST(Rims, EdgesThatDisagreeAreFollowedAndEndsEnd) {
  EXPECT_EQ(find_rims({{0, 1}, {2, 1}, {2, 0}}).size(), 1U);
  EXPECT_EQ(find_rims({{0, 1}, {1, 2}}), (Rims{{0, 1, 2}}));
}

TEST(Rims, RunAgainstTheFacesAround) {
  const Surface sheet = test::square_sheet(3, 1);
  const Rims rims = find_rims(rim_edges(sheet.triangles, test::twins_of(sheet)));
  ASSERT_EQ(rims.size(), 1U);
  EXPECT_EQ(rims[0].size(), 12U);
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 0; i < 12; ++i)
    area += sheet.positions[rims[0][i]].cross(sheet.positions[rims[0][(i + 1) % 12]]) / 2;
  EXPECT_LT((area + sheet.area_vector2(0).normalized()).norm(), 1e-12);
}

TEST(Rims, ARectangleMeasuresWhatItDoes) {
  const Hole hole = measure_rim({{10, 0, 5}, {13, 0, 5}, {13, 4, 5}, {10, 4, 5}});
  EXPECT_DOUBLE_EQ(hole.length, 14);
  EXPECT_NEAR(hole.diameter, 5, 1e-9);
  EXPECT_DOUBLE_EQ(hole.area, 12);
  EXPECT_EQ(hole.centre, (Point{11.5, 2, 5}));
  EXPECT_EQ(hole.edges, 4);
  EXPECT_FALSE(hole.closed);
}

TEST(Rims, ACircleHasItsDiameterAtAnySampling) {
  for (const int n : {3, 7, 1000}) {
    std::vector<Vec3> corners;
    for (int i = 0; i < n; ++i)
      corners.emplace_back(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 0);
    EXPECT_NEAR(measure_rim(corners).diameter, 2, 1e-9);
  }
}

}  // namespace
}  // namespace filmsticking
