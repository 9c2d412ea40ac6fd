// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/plane_triangulation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace filmsticking {
namespace {

double area(const std::vector<Vec3>& corners, const std::vector<Corners>& faces) {
  double sum = 0;
  for (const Corners& t : faces)
    sum += (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]).norm() / 2;
  return sum;
}

TEST(PlaneTriangulation, FillsAPolygonThatIsNotConvex) {
  const std::vector<Vec3> corners{{0, 0, 0}, {4, 0, 0.1}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0.1}};
  const std::vector<Corners> faces = plane_triangulation(corners);
  ASSERT_EQ(faces.size(), 3U);
  EXPECT_NEAR(area(corners, faces), 10, 0.1);
  for (const Corners& t : faces)
    EXPECT_GT((corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]).z(), 0);
}

TEST(PlaneTriangulation, TakesLongRims) {
  std::vector<Vec3> corners;
  constexpr int kCorners = 20000;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * M_PI * i / kCorners, r = 1 + 0.1 * std::sin(40 * angle);
    corners.emplace_back(0.3, r * std::cos(angle), r * std::sin(angle));
  }
  EXPECT_EQ(plane_triangulation(corners).size(), static_cast<std::size_t>(kCorners - 2));
}

TEST(PlaneTriangulation, RefusesWhatIsNoPolygon) {
  EXPECT_TRUE(plane_triangulation({{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 4, 0}}).empty());  // crosses itself
  EXPECT_TRUE(plane_triangulation({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}).empty());             // without area
  EXPECT_TRUE(plane_triangulation({{0, 0, 0}, {1, 0, 0}}).empty());
  EXPECT_TRUE(plane_triangulation({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}})
                  .empty());  // touches
  EXPECT_TRUE(
      plane_triangulation({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 0}, {0, 4, 0}}).empty());  // on an edge
}

}  // namespace
}  // namespace filmsticking
