// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/outliers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "filmsticking/reconstruct.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

TEST(Outliers, NoneOnSurfacesSampledEvenly) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const auto& points : {test::sphere(3000, seed), test::torus(3000, seed),
                               test::box(3000, seed, {1, 1, 0.1}), test::relief(3000, seed, 0.3)})
      EXPECT_EQ(reconstruct(points).report.outliers, 0);
}

TEST(Outliers, FarOnesAreLeftOffUnlessWanted) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    auto points = test::sphere(4000, seed);
    const std::size_t clean = points.size();
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-1.5, 1.5);
    for (int i = 0; i < 200; ++i) points.push_back({uniform(random), uniform(random), uniform(random)});
    const Result result = reconstruct(points);
    ASSERT_EQ(result.status, Status::Ok);
    EXPECT_GE(result.report.outliers, 100);
    EXPECT_LE(result.report.outliers, 200);
    EXPECT_EQ(result.report.components, 1);
    EXPECT_EQ(result.report.genus, 0);
    std::set<std::int32_t> on(result.vertices.begin(), result.vertices.end());
    std::size_t sampled = 0;
    for (std::size_t i = 0; i < clean; ++i) sampled += on.count(static_cast<std::int32_t>(i));
    EXPECT_GE(static_cast<double>(sampled), 0.99 * static_cast<double>(clean));
    const double spacing = std::sqrt(4 * M_PI / static_cast<double>(clean));
    std::size_t far = 0, far_on = 0;
    for (std::size_t i = clean; i < points.size(); ++i) {
      const Point& p = points[i];
      if (std::abs(std::hypot(p[0], p[1], p[2]) - 1) < 5 * spacing) continue;
      ++far;
      far_on += on.count(static_cast<std::int32_t>(i));
    }
    EXPECT_LE(6 * far_on, far);

    Options all;
    all.keep_outliers = true;
    const Result kept = reconstruct(points, all);
    EXPECT_EQ(kept.report.outliers, 0);
    EXPECT_GT(kept.report.interpolated, result.report.interpolated);
  }
}

TEST(Outliers, AreNotFoundWhereAllPointsAreScattered) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Point> points;
  for (int i = 0; i < 500; ++i) points.push_back({uniform(random), uniform(random), uniform(random)});
  const Result result = reconstruct(points);
  EXPECT_LE(result.report.outliers, 10);
}

TEST(Outliers, NoneIsDroppedWhereTheyWouldBeTooMany) {
  // So uneven that over a third of the sites would be outliers.
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 random(seed);
    std::lognormal_distribution<double> radius(0, 3);
    std::normal_distribution<double> normal;
    std::vector<Point> points;
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = Vec3(normal(random), normal(random), normal(random)).normalized() * radius(random);
      points.push_back({p.x(), p.y(), p.z()});
    }
    SiteSet set = make_site_set(points);
    const SiteSet before = set;
    SiteGeometry geometry = site_geometry(set.perturbed);
    const SiteGeometry geometry_before = geometry;
    const std::int64_t dropped = drop_outliers(set, points, geometry);
    EXPECT_EQ(set.size() + dropped, before.size());
    EXPECT_EQ(geometry.spacing.size(), set.size());
    if (dropped > 0) continue;
    EXPECT_EQ(set.perturbed, before.perturbed);
    EXPECT_EQ(set.input, before.input);
    EXPECT_EQ(geometry.spacing, geometry_before.spacing);
  }
}

}  // namespace
}  // namespace filmsticking
