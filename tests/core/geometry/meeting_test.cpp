// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/meeting.h"

#include <gtest/gtest.h>

#include <vector>

namespace filmsticking {
namespace {

TEST(Meeting, Regression_PiecesOnACommonEdgeMayStillCross) {
  // A face that leaves the common edge 01 into the tetrahedron, and one that leaves it away from it.
  const std::vector<Vec3> at{{0, 0, 0}, {1, 0, 0}, {-0.5, 1, 1}, {-0.5, 1, -1}, {1.5, 1, 0}, {1.5, -1, 0}};
  EXPECT_FALSE((Meeting<4, 3>(at, {0, 1, 2, 3}, {0, 1, 4}, 1e-7).in_common_corners_only()));
  EXPECT_TRUE((Meeting<4, 3>(at, {0, 1, 2, 3}, {0, 1, 5}, 1e-7).in_common_corners_only()));
}

TEST(Meeting, IsToldByPlanesBetween) {
  const std::vector<Vec3> at{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2},
                             {2, 2, 2}, {3, 2, 2}, {2, 3, 2}, {2, 2, 3}};
  EXPECT_TRUE((Meeting<4, 4>(at, {0, 1, 2, 3}, {5, 6, 7, 8}, 1e-7).in_common_corners_only()));
  EXPECT_FALSE((Meeting<4, 4>(at, {0, 1, 2, 3}, {4, 6, 7, 8}, 1e-7).in_common_corners_only()));
  EXPECT_TRUE((Meeting<4, 3>(at, {0, 1, 2, 3}, {3, 5, 8}, 1e-7).in_common_corners_only()));
  EXPECT_FALSE((Meeting<4, 3>(at, {0, 1, 2, 3}, {3, 4, 5}, 1e-7).in_common_corners_only()));
}

}  // namespace
}  // namespace filmsticking
