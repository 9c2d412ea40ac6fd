// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/nearest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

std::vector<Vec3> random_points(int n, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i)
    points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  return points;
}

std::vector<Index> sorted_by_distance(const std::vector<Vec3>& points, const Vec3& x) {
  std::vector<std::pair<double, Index>> all;
  for (std::size_t i = 0; i < points.size(); ++i)
    all.emplace_back((points[i] - x).squaredNorm(), static_cast<Index>(i));
  std::sort(all.begin(), all.end());
  std::vector<Index> ids;
  for (const auto& entry : all) ids.push_back(entry.second);
  return ids;
}

TEST(PointTree, FindsThePointsOfASortByDistance) {
  const std::vector<Vec3> points = random_points(2000, 1);
  const PointTree tree(points);
  for (const Vec3& x : random_points(50, 2)) {
    std::vector<Index> all = sorted_by_distance(points, x);
    double distance2 = 0;
    EXPECT_EQ(tree.nearest(x, &distance2), all[0]);
    EXPECT_EQ(distance2, (points[all[0]] - x).squaredNorm());
    all.resize(20);
    EXPECT_EQ(tree.nearest(x, 20), all);
  }
}

TEST(PointTree, OfEqualDistancesTheFirstPointIsNearer) {
  std::vector<Vec3> points;  // a lattice, from whose points many are equally far
  for (int i = 0; i < 1000; ++i) points.emplace_back(i / 100, i / 10 % 10, i % 10);
  const PointTree tree(points);
  for (int i = 0; i < 1000; i += 37) {
    std::vector<Index> all = sorted_by_distance(points, points[i]);
    all.resize(12);
    EXPECT_EQ(tree.nearest(points[i], 12), all);
  }
}

TEST(PointTree, OfFewPointsFindsAllOfThem) {
  EXPECT_EQ(PointTree({}).nearest({0, 0, 0}), kNone);
  EXPECT_TRUE(PointTree({}).nearest({0, 0, 0}, 3).empty());
  const std::vector<Vec3> two{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(PointTree(two).nearest({0.9, 0, 0}, 7), (std::vector<Index>{1, 0}));
}

TEST(SurfaceTree, FindsThePlaceOnASurfaceThatIsNearest) {
  const Surface ball = test::ball();
  const SurfaceTree tree(ball);
  for (const Vec3& x : random_points(50, 3)) {
    const SurfaceTree::Hit hit = tree.nearest(x);
    // No vertex is nearer, and the place is on its triangle.
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& p : ball.positions) least = std::min(least, (p - x).norm());
    EXPECT_LE((hit.point - x).norm(), least + 1e-12);
    const Vec3 normal = ball.area_vector2(hit.triangle).normalized();
    EXPECT_NEAR(normal.dot(hit.point - ball.corner(hit.triangle, 0)), 0, 1e-9);
  }
}

}  // namespace
}  // namespace filmsticking
