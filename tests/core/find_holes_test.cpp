// SPDX-License-Identifier: GPL-3.0-or-later
// find_holes(), and Options::max_hole: between a closed result and an open one.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "filmsticking/holes.h"
#include "filmsticking/reconstruct.h"
#include "support/clouds.h"
#include "support/surface_check.h"

namespace filmsticking {
namespace {

// A sphere of radius 1 without what is near the poles: holes of diameter 0.6 and 1.2.
std::vector<Point> holed_sphere(double scale) {
  std::vector<Point> points;
  for (const Point& p : test::sphere(8000, 1)) {
    const double r = std::hypot(p[0], p[1]);
    if ((p[2] > 0 && r < 0.3) || (p[2] < 0 && r < 0.6)) continue;
    points.push_back({1000 + scale * p[0], scale * p[1], scale * p[2]});
  }
  return points;
}

Result reconstruct_with(const std::vector<Point>& points, double max_hole) {
  Options options;
  options.max_hole = max_hole;
  return reconstruct(points, options);
}

Mesh mesh_of(const Result& result, const std::vector<Point>& points) {
  Mesh mesh;
  for (const std::int32_t i : result.vertices)
    mesh.positions.push_back(points.at(static_cast<std::size_t>(i)));
  mesh.triangles = result.triangles;
  return mesh;
}

TEST(MaxHole, ClosesHolesUpToADiameterInAnyUnit) {
  for (const double scale : {1.0, 100.0}) {
    const std::vector<Point> points = holed_sphere(scale);
    for (const auto& [max_hole, open] : {std::pair{0.5, 2}, std::pair{0.9, 1}, std::pair{1.6, 0}}) {
      const Result result = reconstruct_with(points, max_hole * scale);
      ASSERT_EQ(result.status, Status::Ok) << result.message;
      EXPECT_EQ(test::surface_fault(mesh_of(result, points), true), "");
      EXPECT_EQ(result.report.boundary_loops, open);
      EXPECT_EQ(result.report.closed, open == 0);
      ASSERT_EQ(result.report.holes.size(), 2U);
      const Hole &wide = result.report.holes[0], &narrow = result.report.holes[1];
      EXPECT_EQ(wide.closed, open == 0);
      EXPECT_EQ(narrow.closed, open < 2);
      EXPECT_NEAR(wide.diameter, 1.2 * scale, 0.15 * scale);
      EXPECT_NEAR(narrow.diameter, 0.6 * scale, 0.12 * scale);
      EXPECT_NEAR(wide.centre[2], -0.8 * scale, 0.05 * scale);
      EXPECT_NEAR(narrow.centre[2], 0.95 * scale, 0.05 * scale);
      EXPECT_NEAR(wide.centre[0], 1000, 0.05 * scale);
      EXPECT_NEAR(wide.area, M_PI * 0.36 * scale * scale, 0.25 * scale * scale);
      EXPECT_GT(wide.length, M_PI * 1.1 * scale);
    }
  }
}

TEST(MaxHole, OfTheBoxIsTheClosedResult) {
  const std::vector<Point> points = holed_sphere(1);
  const Result closed = reconstruct(points), all = reconstruct_with(points, 4);
  EXPECT_EQ(all.triangles, closed.triangles);
  EXPECT_EQ(all.vertices, closed.vertices);
  EXPECT_TRUE(all.report.closed);
}

TEST(MaxHole, LeavesTheRimOfADepthImageOpen) {
  std::vector<Point> points;
  for (const Point& p : test::depth_view({{0, 0, -3, 1}, {0, 0, -30, 40}}, {0, 0, 0}, 0.02))
    points.push_back(p);
  Options options;
  options.open_boundary = true;
  const Result open = reconstruct(points, options);
  ASSERT_FALSE(open.report.holes.empty());
  const double widest = open.report.holes[0].diameter;
  const Result result = reconstruct_with(points, 0.9 * widest);
  EXPECT_EQ(test::surface_fault(mesh_of(result, points), true), "");
  EXPECT_FALSE(result.report.closed);
  EXPECT_FALSE(result.report.holes[0].closed);
}

TEST(MaxHole, IsALength) {
  for (const double wrong : {-1.0, static_cast<double>(INFINITY), std::nan("")})
    EXPECT_EQ(reconstruct_with(test::sphere(100, 1), wrong).status, Status::InvalidOptions);
}

// A square grid of cells 1 wide; two cells that share a corner are left out.
TEST(FindHoles, ThatTouchAreSeveral) {
  constexpr int kCells = 4;
  std::vector<Point> places;
  std::vector<Triangle> triangles;
  for (int i = 0; i <= kCells; ++i)
    for (int j = 0; j <= kCells; ++j) places.push_back({1.0 * i, 1.0 * j, 0});
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      if (i == j && (i == 1 || i == 2)) continue;
      const int a = i * (kCells + 1) + j, b = a + kCells + 1;
      triangles.push_back({a, b, b + 1}), triangles.push_back({a, b + 1, a + 1});
    }
  std::vector<Hole> holes;
  ASSERT_EQ(find_holes(places, triangles, holes), Status::Ok);
  ASSERT_EQ(holes.size(), 3U);
  EXPECT_DOUBLE_EQ(holes[0].length, 16);
  EXPECT_EQ(holes[0].normal, (Point{0, 0, -1}));  // what fills the rest of the plane
  for (const Hole& hole : {holes[1], holes[2]}) {
    EXPECT_DOUBLE_EQ(hole.length, 4);
    EXPECT_DOUBLE_EQ(hole.area, 1);
    EXPECT_EQ(hole.normal, (Point{0, 0, 1}));
  }
}

TEST(FindHoles, HaveMeasuresWhereverTheyAre) {
  for (const auto& [scale, away] :
       {std::pair{1e-30, 7.0}, std::pair{1e-90, 7.0}, std::pair{1e90, 7.0}, std::pair{1.0, 4e6}}) {
    std::vector<Point> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (Point& p : square)
      for (double& x : p) x = (x + away) * scale;
    std::vector<Hole> holes;
    ASSERT_EQ(find_holes(square, {{0, 1, 2}, {0, 2, 3}}, holes), Status::Ok);
    ASSERT_EQ(holes.size(), 1U);
    EXPECT_NEAR(holes[0].diameter / scale, std::sqrt(2), 1e-9);
    EXPECT_NEAR(holes[0].length / scale, 4, 1e-9);
    EXPECT_NEAR(holes[0].area / scale / scale, 1, 1e-9);
    EXPECT_NEAR(holes[0].centre[0] / scale, 0.5 + away, 1e-9);
    EXPECT_EQ(holes[0].normal, (Point{0, 0, -1}));
  }
}

TEST(FindHoles, OfAnyTriangles) {
  const std::vector<Point> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 5}};
  std::vector<Hole> holes;
  EXPECT_EQ(find_holes(square, {{0, 1, 2}, {0, 2, 3}}, holes), Status::Ok);
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_DOUBLE_EQ(holes[0].length, 4);
  EXPECT_DOUBLE_EQ(holes[0].area, 1);
  EXPECT_NEAR(holes[0].diameter, std::sqrt(2), 1e-9);
  EXPECT_EQ(find_holes(square, {{0, 1, 2}, {0, 3, 2}}, holes), Status::Ok);  // they disagree
  EXPECT_EQ(holes.size(), 1U);
  EXPECT_EQ(find_holes(square, {{0, 1, 2}, {0, 2, 1}}, holes), Status::Ok);
  EXPECT_TRUE(holes.empty());
  EXPECT_EQ(find_holes(square, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, holes), Status::Ok);  // an edge of three
  EXPECT_FALSE(holes.empty());
  EXPECT_EQ(find_holes({}, {}, holes), Status::Ok);
  EXPECT_EQ(find_holes(square, {{0, 1, 5}}, holes), Status::InvalidInput);
  EXPECT_EQ(find_holes(square, {{0, 1, -1}}, holes), Status::InvalidInput);
  EXPECT_EQ(find_holes({{NAN, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}}, holes), Status::InvalidInput);
  EXPECT_TRUE(holes.empty());
}

}  // namespace
}  // namespace filmsticking
