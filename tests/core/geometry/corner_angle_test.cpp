// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/corner_angle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace filmsticking {
namespace {

TEST(CornerAngle, IsTheAngleBetweenTwoDirections) {
  const Vec3 apex(3, -2, 5);
  for (int degrees = 0; degrees <= 180; degrees += 5) {
    const double angle = degrees * M_PI / 180;
    const Vec3 p(0.1, 0, 0), q(7 * std::cos(angle), 7 * std::sin(angle), 0);
    EXPECT_NEAR(corner_angle(apex, apex + p, apex + q), angle, 1e-12);
    EXPECT_EQ(corner_angle(apex, apex + p, apex + q), corner_angle(apex, apex + q, apex + p));
  }
}

TEST(CornerAngle, IsZeroWithoutADirection) {
  EXPECT_EQ(corner_angle({1, 1, 1}, {1, 1, 1}, {2, 3, 4}), 0);
  EXPECT_EQ(corner_angle({1, 1, 1}, {2, 3, 4}, {1, 1, 1}), 0);
}

TEST(CornerAngle, IsExactForNarrowCorners) {
  EXPECT_NEAR(corner_angle({0, 0, 0}, {1, 0, 0}, {1, 1e-10, 0}), 1e-10, 1e-20);
}

}  // namespace
}  // namespace filmsticking
