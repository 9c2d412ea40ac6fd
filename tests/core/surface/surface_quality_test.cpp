// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

SiteGeometry geometry_of(const Surface& surface) {
  SiteGeometry geometry = site_geometry(surface.positions);
  return geometry;
}

TEST(SurfaceQuality, OfASmoothBallIsNearlyPerfect) {
  const Surface ball = test::ball();
  const SurfaceQuality quality = surface_quality(ball, geometry_of(ball));
  EXPECT_LT(quality.disagreement, 0.02);
  EXPECT_EQ(quality.conflict, 0);
  EXPECT_EQ(quality.wide_faces, 0);
  EXPECT_EQ(quality.bridging, 0);
  const auto sites = static_cast<double>(ball.positions.size());
  EXPECT_GT(quality.area, 0.5 * sites);
  EXPECT_LT(quality.area, 2 * sites);
  EXPECT_LT(quality.roughness, quality.disagreement * quality.area / kUsualDeviation);  // ln(1 + x) < x
  EXPECT_GT(quality.roughness, 0);
  EXPECT_EQ(quality.handles, 0);
  EXPECT_EQ(quality.complexity, 1);
  EXPECT_EQ(quality.off, 0);
}

TEST(SurfaceQuality, AWideFacePaysForTheNormalThatNobodyKnows) {
  double mean = 0;
  constexpr int kSteps = 100000;
  for (int i = 0; i < kSteps; ++i) mean += std::log1p((i + 0.5) / kSteps / kUsualDeviation) / kSteps;
  EXPECT_NEAR(kAnyNormal, mean, 0.01);

  Surface part = test::ball_without([](const Vec3& p) { return p.z() < 0; });
  const SiteGeometry geometry = geometry_of(part);
  const SurfaceQuality before = surface_quality(part, geometry);
  Index far[3] = {0, 0, 0};  // three sites that span the ball
  for (Index v = 0; v < static_cast<Index>(part.positions.size()); ++v)
    for (int k = 0; k < 3; ++k) {
      const double a = k * 2 * M_PI / 3;
      const Vec3 way(std::cos(a), std::sin(a), -0.2);
      if (way.dot(part.positions[v]) > way.dot(part.positions[far[k]])) far[k] = v;
    }
  part.triangles.push_back({far[0], far[1], far[2]});
  const SurfaceQuality lidded = surface_quality(part, geometry);
  ASSERT_EQ(lidded.wide_faces, before.wide_faces + 1);
  EXPECT_NEAR(lidded.roughness - before.roughness, kAnyNormal, 1e-9);
}

TEST(SurfaceQuality, CountsComponentsLoopsAndSitesOff) {
  const Surface ball = test::ball_without([](const Vec3& p) { return std::abs(p.z()) < 0.4; });
  const Surface caps = surface_of_sites(ball.triangles, ball.positions);  // without the vertices between
  const SurfaceQuality two = surface_quality(caps, geometry_of(ball));
  EXPECT_EQ(two.complexity, 3);  // two components, and a half for each of two rims
  EXPECT_EQ(two.handles, 0);
  Surface part = test::ball_without([](const Vec3& p) { return p.z() < 0; });
  const SiteGeometry geometry = geometry_of(part);
  const std::int64_t all = static_cast<std::int64_t>(part.positions.size());
  part = surface_of_sites(part.triangles, part.positions);
  EXPECT_EQ(surface_quality(part, geometry).off, all - static_cast<std::int64_t>(part.positions.size()));
  EXPECT_GT(surface_quality(part, geometry).off, 0);
}

TEST(SurfaceQuality, KnowsAHandle) {
  constexpr int n = 24;
  std::vector<Vec3> positions;
  std::vector<Corners> triangles;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / n, r = 0.3 + 0.15 * std::cos(v);
      positions.emplace_back(r * std::cos(u), r * std::sin(u), 0.15 * std::sin(v));
      const Index a = i * n + j, b = (i + 1) % n * n + j, c = (i + 1) % n * n + (j + 1) % n,
                  d = i * n + (j + 1) % n;
      triangles.push_back({a, b, c}), triangles.push_back({a, c, d});
    }
  const Surface torus = test::surface_of(std::move(positions), std::move(triangles));
  ASSERT_TRUE(test::check(torus).ok());
  const SurfaceQuality quality = surface_quality(torus, geometry_of(torus));
  EXPECT_EQ(quality.handles, 1);
  EXPECT_EQ(quality.complexity, 2);
}

TEST(SurfaceQuality, SeesBridgesAndOpposedNeighbours) {
  const Surface sheet = test::square_sheet(12, 1);
  const SiteGeometry geometry = geometry_of(sheet);
  Surface turned = sheet;
  for (std::size_t t = 0; t < turned.triangles.size() / 2; ++t)
    std::swap(turned.triangles[t][1], turned.triangles[t][2]);
  EXPECT_EQ(surface_quality(sheet, geometry).conflict, 0);
  EXPECT_GT(surface_quality(turned, geometry).conflict, 0.02);
  EXPECT_LT(surface_quality(turned, geometry).conflict, 0.5);
  Surface bridged = sheet;
  bridged.triangles.push_back({0, 12, 168});  // three corners of the sheet
  const SurfaceQuality quality = surface_quality(bridged, geometry);
  EXPECT_EQ(quality.wide_faces, 1);
  EXPECT_GT(quality.area, 1.2 * surface_quality(sheet, geometry).area);
  EXPECT_NEAR(quality.bridging, 1. / 3, 1e-9);  // half of the sheet's area, of one and a half
}

// The two sides of a plate oppose each other, too.
TEST(SurfaceQuality, BackToBackIsNoConflict) {
  const Surface sheet = test::square_sheet(12, 1);
  for (const bool outward : {true, false}) {
    Surface plate = sheet;
    const auto n = static_cast<Index>(sheet.positions.size());
    for (Vec3 p : sheet.positions) plate.positions.push_back(p - Vec3(0, 0, 0.03));
    for (const Corners& t : sheet.triangles) plate.triangles.push_back({t[0] + n, t[2] + n, t[1] + n});
    if (!outward)
      for (Corners& t : plate.triangles) std::swap(t[1], t[2]);
    plate = test::surface_of(plate.positions, plate.triangles);
    const double conflict = surface_quality(plate, geometry_of(plate)).conflict;
    EXPECT_EQ(conflict > 0.2, !outward);
    EXPECT_EQ(conflict > 0, !outward);
  }
}

TEST(SurfaceQuality, OfNothingIsTheWorst) {
  const SurfaceQuality quality = surface_quality(Surface(), geometry_of(test::ball()));
  EXPECT_EQ(quality.disagreement, 1);
  EXPECT_EQ(quality.conflict, 1);
  EXPECT_EQ(quality.off, static_cast<std::int64_t>(test::ball().positions.size()));
}

}  // namespace
}  // namespace filmsticking
