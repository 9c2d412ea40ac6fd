// SPDX-License-Identifier: GPL-3.0-or-later
// point_normals(): one unit normal for every input point.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "filmsticking/normals.h"
#include "filmsticking/reconstruct.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Normal> normals_of(const std::vector<Point>& points, const Options& options = {}) {
  const Result result = reconstruct(points, options);
  EXPECT_EQ(result.status, Status::Ok) << result.message;
  std::vector<Normal> normals;
  EXPECT_EQ(point_normals(points, result.vertices, result.triangles, normals), Status::Ok);
  EXPECT_EQ(normals.size(), points.size());
  return normals;
}

double dot(const Normal& n, const Point& p) { return n[0] * p[0] + n[1] * p[1] + n[2] * p[2]; }

double length(const Normal& n) { return std::hypot(n[0], n[1], n[2]); }

TEST(PointNormals, PointOutwardFromAClosedSurfaceInAnyUnit) {
  for (const double scale : {1e-30, 1.0, 1e30}) {
    std::vector<Point> points = test::sphere(2000, 1);
    for (Point& p : points)
      for (double& x : p) x *= scale;
    const std::vector<Normal> normals = normals_of(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(length(normals[i]), 1, 1e-6);
      EXPECT_GT(dot(normals[i], points[i]), 0.95 * scale);
    }
  }
}

TEST(PointNormals, PointIntoACavity) {
  std::vector<Point> points = test::sphere(4000, 1);
  for (const Point& p : test::sphere(1000, 2, {0, 0, 0}, 0.5)) points.push_back(p);
  const std::vector<Normal> normals = normals_of(points);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_GT((i < 4000 ? 1 : -1) * dot(normals[i], points[i]), 0) << i;
}

TEST(PointNormals, PointTowardsTheSensorOfADepthImage) {
  const std::vector<Point> points = test::depth_view({{0, 0, -3, 1}}, {0, 0, 0}, 0.02);
  Options options;
  options.open_boundary = true;
  const std::vector<Normal> normals = normals_of(points, options);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT(dot(normals[i], points[i]), 0);
}

TEST(PointNormals, OfPointsLeftOffAreThoseOfTheNearestPlace) {
  std::vector<Point> points = test::sphere(3000, 1);
  const std::size_t on = points.size();
  points.push_back(points[17]);            // repeated
  points.push_back({0, 0, 5});             // outliers
  points.push_back({-1e30, 0, 0});         // absurdly far
  points.push_back({0, 1e300, 0});         // its square is infinite
  points.push_back({0, std::nan(""), 0});  // not finite
  points.push_back({kInfinity, -kInfinity, 0});
  const std::vector<Normal> normals = normals_of(points);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(normals[on][k], normals[17][k], 1e-4);
  EXPECT_GT(normals[on + 1][2], 0.98);
  EXPECT_LT(normals[on + 2][0], -0.98);
  EXPECT_GT(normals[on + 3][1], 0.98);
  for (std::size_t i = on + 4; i < points.size(); ++i)
    for (const float x : normals[i]) EXPECT_TRUE(std::isnan(x));
}

TEST(PointNormals, OnNoisyPointsOfATorusHaveTheRightSides) {
  std::vector<Point> clean = test::torus(6000, 1), points = clean;
  test::Random random(7);
  const double area = 4 * M_PI * M_PI * 0.4, spacing = std::sqrt(area / 6000);
  for (Point& p : points)  // uniform, of the deviation of half a spacing
    for (double& x : p) x += random.uniform(-1, 1) * 0.5 * spacing * std::sqrt(3);
  const std::vector<Normal> normals = normals_of(points);
  int right = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double r = std::hypot(clean[i][0], clean[i][1]);
    right += dot(normals[i], {clean[i][0] * (1 - 1 / r), clean[i][1] * (1 - 1 / r), clean[i][2]}) > 0;
  }
  EXPECT_GT(right, 0.99 * 6000);
}

TEST(PointNormals, DoNotDependOnTheThreads) {
  std::vector<Point> points = test::torus(5000, 1);
  for (int i = 0; i < 3000; ++i) points.push_back(points[static_cast<std::size_t>(i)]);
  const Result result = reconstruct(points);
  std::vector<Normal> one, many;
  EXPECT_EQ(point_normals(points, result.vertices, result.triangles, one, 1), Status::Ok);
  EXPECT_EQ(point_normals(points, result.vertices, result.triangles, many, 4), Status::Ok);
  EXPECT_EQ(one, many);
}

TEST(PointNormals, RefuseAMeshThatIsNotOfThePoints) {
  const std::vector<Point> points = test::sphere(10, 1);
  std::vector<Normal> normals{Normal{}};
  EXPECT_EQ(point_normals(points, {0, 1, 2}, {}, normals), Status::InvalidInput);
  EXPECT_TRUE(normals.empty());
  EXPECT_EQ(point_normals(points, {0, 1, 10}, {{0, 1, 2}}, normals), Status::InvalidInput);
  EXPECT_EQ(point_normals(points, {0, 1, -1}, {{0, 1, 2}}, normals), Status::InvalidInput);
  EXPECT_EQ(point_normals(points, {0, 1, 2}, {{0, 1, 3}}, normals), Status::InvalidInput);
  EXPECT_EQ(point_normals(points, {0, 1, 2}, {{-1, 1, 2}}, normals), Status::InvalidInput);
  EXPECT_EQ(point_normals(points, {0, 1, 2}, {{0, 1, 2}}, normals), Status::Ok);
}

TEST(PointNormals, StopWhenAsked) {
  const std::vector<Point> points = test::sphere(100, 1);
  const Result result = reconstruct(points);
  const std::atomic<bool> stop{true};
  std::vector<Normal> normals;
  EXPECT_EQ(point_normals(points, result.vertices, result.triangles, normals, 0, &stop), Status::Cancelled);
  EXPECT_TRUE(normals.empty());
}

}  // namespace
}  // namespace filmsticking
