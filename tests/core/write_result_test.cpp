// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "failure.h"
#include "support/clouds.h"
#include "support/surfaces.h"

namespace filmsticking {
namespace {

struct Case {
  std::vector<Point> points;
  SiteSet sites;
  SiteGeometry geometry;
  Surface surface;
};

// A ball of test::ball(), whose points come in another order, with one that is on no face.
Case ball_case() {
  Case one;
  const Surface ball = test::ball();
  const auto n = static_cast<Index>(ball.positions.size());
  std::vector<Index> place(n);
  for (Index v = 0; v < n; ++v) place[v] = (7 * v + 3) % n;
  one.points.assign(static_cast<std::size_t>(n) + 1, Point{5, 5, 5});
  for (Index v = 0; v < n; ++v)
    one.points[place[v]] = {ball.positions[v].x(), ball.positions[v].y(), ball.positions[v].z()};
  one.sites = make_site_set(one.points);
  one.geometry = site_geometry(one.sites.perturbed);
  std::vector<Index> site(one.points.size());
  for (std::size_t s = 0; s < one.sites.size(); ++s) site[one.sites.input[s]] = static_cast<Index>(s);
  std::vector<Corners> triangles = ball.triangles;
  for (Corners& t : triangles)
    for (Index& v : t) v = site[place[v]];
  one.surface = unsorted_surface_of_sites(std::move(triangles), one.sites.perturbed);
  return one;
}

Result written(const Case& one, bool may_be_open = false, const std::vector<float>& stability = {}) {
  Result result;
  result.report.points = static_cast<std::int64_t>(one.points.size());
  write_result(FinishedSurface(one.surface), one.sites, one.geometry, stability, may_be_open, result);
  return result;
}

TEST(WriteResult, NamesInputPointsInRisingOrderAndSortsTriangles) {
  const Case one = ball_case();
  const Result result = written(one);
  EXPECT_TRUE(std::is_sorted(result.vertices.begin(), result.vertices.end()));
  EXPECT_EQ(result.vertices.size() + 1, one.points.size());
  EXPECT_TRUE(std::is_sorted(result.triangles.begin(), result.triangles.end()));
  for (const Triangle& t : result.triangles) EXPECT_EQ(t[0], std::min({t[0], t[1], t[2]}));
  // The same faces, with the same winding.
  const auto places = [&](const std::vector<Point>& corners) {
    auto sorted = corners;
    std::rotate(sorted.begin(), std::min_element(sorted.begin(), sorted.end()), sorted.end());
    return sorted;
  };
  std::vector<std::vector<Point>> before, after;
  for (const Corners& t : one.surface.triangles) {
    std::vector<Point> corners;
    for (Index v : t) corners.push_back(one.points[one.sites.input[one.surface.site[v]]]);
    before.push_back(places(corners));
  }
  for (const Triangle& t : result.triangles) {
    std::vector<Point> corners;
    for (const std::int32_t v : t) corners.push_back(one.points[result.vertices[v]]);
    after.push_back(places(corners));
  }
  std::sort(before.begin(), before.end()), std::sort(after.begin(), after.end());
  EXPECT_EQ(before, after);
}

TEST(WriteResult, CountsWhatTheSurfaceIs) {
  const Case one = ball_case();
  const Report report = written(one).report;
  EXPECT_TRUE(report.closed && report.manifold);
  EXPECT_EQ(report.components, 1);
  EXPECT_EQ(report.genus, 0);
  EXPECT_EQ(report.interpolated + 1, report.points);
  EXPECT_EQ(report.triangles, 2 * (report.interpolated - 2));
}

TEST(WriteResult, AFaceIsAsStableAsItsLeastCorner) {
  const Case one = ball_case();
  EXPECT_TRUE(written(one).stability.empty());
  std::vector<float> of_site(one.sites.size());
  for (std::size_t s = 0; s < of_site.size(); ++s) of_site[s] = static_cast<float>(s % 5) / 4;
  const Result result = written(one, false, of_site);
  ASSERT_EQ(result.stability.size(), result.triangles.size());
  std::vector<float> of_point(one.points.size());
  for (std::size_t s = 0; s < of_site.size(); ++s) of_point[one.sites.input[s]] = of_site[s];
  double sum = 0;
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    float least = 1;
    for (const std::int32_t v : result.triangles[t]) least = std::min(least, of_point[result.vertices[v]]);
    EXPECT_EQ(result.stability[t], least);
    sum += result.stability[t];
  }
  EXPECT_DOUBLE_EQ(result.report.stability, sum / static_cast<double>(result.stability.size()));
}

TEST(WriteResult, RefusesAHoleUnlessTheResultMayBeOpen) {
  Case one = ball_case();
  one.surface.triangles.pop_back();
  EXPECT_THROW(written(one), Failure);
  const Report report = written(one, true).report;
  EXPECT_EQ(report.boundary_edges, 3);
  EXPECT_EQ(report.boundary_loops, 1);
  EXPECT_EQ(report.genus, 0);
}

TEST(WriteResult, RefusesWhatIsNoManifold) {
  Case one = ball_case();
  one.surface.triangles.push_back(one.surface.triangles.front());
  EXPECT_THROW(written(one, true), Failure);
}

}  // namespace
}  // namespace filmsticking
