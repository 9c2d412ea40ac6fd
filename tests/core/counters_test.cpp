// SPDX-License-Identifier: GPL-3.0-or-later
// What film steps and reports count: each counter's bound, which follows from what is counted, whatever the
// cloud; and that repairs are (next to) none on clean clouds, so that none of them hides a defect.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "filmsticking/reconstruct.h"
#include "support/clean_clouds.h"

namespace filmsticking {
namespace {

TEST(Counters, OfFilmStepsKeepTheirBounds) {
  for (const auto& [name, points] : test::clean_clouds()) {
    if (name.find('1') == std::string::npos) continue;
    SCOPED_TRACE(name);
    const Result result = reconstruct(points, Options::paper());
    ASSERT_EQ(result.status, Status::Ok) << result.message;
    const Report& r = result.report;
    ASSERT_FALSE(r.steps.empty());
    for (const StepRecord& step : r.steps) {
      EXPECT_LE(step.attracted, r.sites);
      EXPECT_LE(step.virtual_left, 1000);
      EXPECT_LE(step.weighted, r.sites);
      EXPECT_LE(step.held, r.tetrahedra);
    }
  }
}

TEST(Counters, OfAReportAddUp) {
  for (const auto& [name, clean] : test::clean_clouds()) {
    if (name.find('2') == std::string::npos) continue;
    SCOPED_TRACE(name);
    std::vector<Point> points = clean;
    for (int i = 0; i < 30; ++i) points.push_back(clean[static_cast<std::size_t>(7 * i)]);
    for (const double strange : {std::nan(""), HUGE_VAL, -HUGE_VAL}) points.push_back({0, strange, 0});
    for (const double far : {-40., 40.}) points.push_back({far, 2 * far, far});
    const Result result = reconstruct(points);
    ASSERT_EQ(result.status, Status::Ok) << result.message;
    const Report& r = result.report;
    EXPECT_EQ(r.points, static_cast<std::int64_t>(points.size()));
    EXPECT_EQ(r.non_finite, 3);
    EXPECT_EQ(r.duplicates, 30);
    EXPECT_EQ(r.sites, static_cast<std::int64_t>(clean.size()) + 2);
    EXPECT_EQ(r.outliers, 2);
    EXPECT_EQ(r.interpolated, r.sites - r.outliers);
    EXPECT_LE(r.inserted, r.interpolated / 200);
    EXPECT_TRUE(r.steps.empty());  // no film stepped in
    EXPECT_EQ(r.rounds, 0);
    EXPECT_EQ(r.boundary_edges, 0);
    EXPECT_EQ(r.boundary_loops, 0);
    // Of a closed surface: V - E + F = 2 (components - genus), and three edges for two faces.
    EXPECT_EQ(r.interpolated - r.triangles / 2, 2 * (r.components - r.genus));
  }
}

}  // namespace
}  // namespace filmsticking
