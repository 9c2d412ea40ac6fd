// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/enclosed_volume.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

TEST(EnclosedVolume, IsExactAtEveryScale) {
  const std::vector<Corners> triangles(std::begin(test::kTetrahedron), std::end(test::kTetrahedron));
  const auto sign = [&](double x, double y, double z, const Point& o) {
    return enclosed_volume_sign(
        triangles,
        std::vector<Point>{o, {o[0] + x, o[1], o[2]}, {o[0], o[1] + y, o[2]}, {o[0], o[1], o[2] + z}});
  };
  const int outward = sign(1, 1, 1, {0, 0, 0});
  EXPECT_EQ(std::abs(outward), 1);
  EXPECT_EQ(sign(1, 1, -1, {0, 0, 0}), -outward);
  EXPECT_EQ(sign(1, 1, 0, {0, 0, 0}), 0);
  EXPECT_EQ(sign(1e308, 1e308, -1e308, {0, 0, 0}), -outward);
  EXPECT_EQ(sign(1e308, 1e-200, 1e-200, {0, 0, 0}), outward);
  EXPECT_EQ(sign(5e-324, -5e-324, 5e-324, {0, 0, 0}), -outward);
  EXPECT_EQ(sign(1e300, 1e300, 1e300, {-1e308, 1e308, 1e308}), outward);
  EXPECT_EQ(sign(1, 1, 1e-9, {1e6, 1e6, 1e6}), outward);
  EXPECT_EQ(sign(1, 1, 1e-12, {1e6, 1e6, 1e6}), 0);  // rounded away already
  EXPECT_EQ(enclosed_volume_sign({}, std::vector<Point>()), 0);
}

TEST(EnclosedVolume, RoundedVolumesCompareByTheirUnit) {
  for (const double scale : {1e-300, 1., 1e300}) {
    const std::vector<Point> small{{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}, {0, 0, scale}};
    std::vector<Point> large = small;
    for (Point& p : large)
      for (double& x : p) x *= 2;
    const double unit = enclosing_unit(large);
    EXPECT_NEAR(rounded_volume(test::kTetrahedron, large, unit),
                8 * rounded_volume(test::kTetrahedron, small, unit),
                1e-9 * rounded_volume(test::kTetrahedron, large, unit));
    EXPECT_GT(rounded_volume(test::kTetrahedron, small, unit), 0);
  }
}

}  // namespace
}  // namespace filmsticking
