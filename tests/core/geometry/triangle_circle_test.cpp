// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_circle.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/clouds.h"

namespace filmsticking {
namespace {

TEST(TriangleCircle, IsThatThroughAllCorners) {
  test::Random random(1);
  for (int i = 0; i < 50; ++i) {
    // Three points on a circle.
    const double radius = random.uniform(0.1, 10), turn = random.uniform(0, 6);
    const auto at = [&](double angle) {
      return Vec3(radius * std::cos(turn + angle), 3, radius * std::sin(turn + angle));
    };
    const Vec3 a = at(0), b = at(random.uniform(0.5, 2)), c = at(random.uniform(2.5, 5));
    EXPECT_NEAR(circumradius2(a, b, c), radius * radius, 1e-9 * radius * radius);
  }
}

TEST(TriangleCircle, WithoutAreaIsTheLargest) {
  EXPECT_EQ(circumradius2({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), std::numeric_limits<double>::max());
  EXPECT_EQ(circumradius2({1, 1, 1}, {1, 1, 1}, {1, 1, 1}), std::numeric_limits<double>::max());
}

}  // namespace
}  // namespace filmsticking
