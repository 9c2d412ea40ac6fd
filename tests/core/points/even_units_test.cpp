// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/even_units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "filmsticking/reconstruct.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

// A sea bed of one unit of slope about 0.3, with its heights in another unit.
std::vector<Point> sea_bed(std::uint64_t seed, double side, double heights, bool along_x = false) {
  test::Random random(seed);
  std::vector<Point> points;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j) {
      const double u = (i + random.uniform(0, 0.6)) / 40, v = (j + random.uniform(0, 0.6)) / 40;
      const double z = -0.3 + 0.1 * std::sin(6 * u) * std::cos(4 * v);
      const Point p{-4.5 + side * u, 48.3 + side * v, heights * side * z};
      points.push_back(along_x ? Point{p[2], p[0], p[1]} : p);
    }
  return points;
}

TEST(EvenUnits, MetresBesideDegreesAreScaledAndMetresBesideMetresAreNot) {
  const Vec3 below(0, 0, -1);
  EXPECT_FALSE(in_even_units(sea_bed(1, 0.02, 1e5), below).empty());
  EXPECT_TRUE(in_even_units(sea_bed(1, 2000, 1), below).empty());
  EXPECT_TRUE(in_even_units(sea_bed(1, 2000, 5), below).empty());
  EXPECT_TRUE(in_even_units(std::vector<Point>(), below).empty());
}

TEST(EvenUnits, OneHeightThatIsNoHeightDecidesNothing) {
  std::vector<Point> points = sea_bed(1, 200, 1);
  points[7][2] = -9999;
  points[8] = {0, 0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_TRUE(in_even_units(points, Vec3(0, 0, -1)).empty());
}

TEST(EvenUnits, ASeaBedInDegreesIsTheSurfaceThatItIsInMetres) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const bool along_x : {false, true}) {
      Options options;
      options.view_direction = along_x ? Point{-2, 0, 0} : Point{0, 0, -1};
      options.open_boundary = true;
      const Result degrees = reconstruct(sea_bed(seed, 0.02, 1e5, along_x), options);
      ASSERT_EQ(degrees.status, Status::Ok) << degrees.message;
      EXPECT_FALSE(degrees.report.warning.empty());
      EXPECT_EQ(degrees.report.interpolated, 1600);
      EXPECT_EQ(degrees.report.components, 1);
      EXPECT_EQ(degrees.report.boundary_loops, 1);
    }
}

}  // namespace
}  // namespace filmsticking
