// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/cloud_fit.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

#include "report/report.h"
#include "support/shapes.h"

namespace filmsticking::mesh_report {
namespace {

using test::box;
using test::Model;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(CloudFit, CountsDistinctPointsAndMeasures) {
  for (const double scale : {1.0, 1e-6, 1e7}) {
    Model mesh = box();
    std::vector<Point> cloud = box().positions;
    cloud.push_back({0.5, 0.5, 1.25});
    cloud.push_back({0.5, 0.25, 0});
    cloud.insert(cloud.end(), {cloud[0], cloud[3], {kNan, 0, 0}});
    for (std::vector<Point>* points : {&mesh.positions, &cloud})
      for (Point& p : *points)
        for (double& x : p) x = x * scale + 8 * scale;
    const CloudFit fit = cloud_fit(make_surface(mesh), cloud);
    EXPECT_EQ(fit.points, 10);
    EXPECT_NEAR(fit.interpolated, 80, 1e-12);
    EXPECT_NEAR(fit.distance_mean.value() / scale, 0.025, 1e-12);
    EXPECT_NEAR(fit.distance_max.value() / scale, 0.25, 1e-12);
  }
}

TEST(CloudFit, AVertexIsThePointOnlyIfItIsThere) {
  std::vector<Point> cloud = box().positions;  // diagonal sqrt(3)
  cloud[0][0] = 1e-7;
  cloud[1][0] += 2e-7;
  EXPECT_NEAR(cloud_fit(make_surface(box()), cloud).interpolated, 87.5, 1e-12);
}

TEST(CloudFit, OfLittle) {
  EXPECT_EQ(cloud_fit(make_surface(box()), {{kNan, 0, 0}}).points, 0);
  EXPECT_EQ(cloud_fit(make_surface(box()), {}).distance_mean, std::nullopt);
  const CloudFit one = cloud_fit(make_surface(box()), {{1, 1, 3}});
  EXPECT_EQ(one.points, 1);
  EXPECT_EQ(one.interpolated, 0);
  EXPECT_NEAR(one.distance_max.value(), 2, 1e-12);
}

}  // namespace
}  // namespace filmsticking::mesh_report
