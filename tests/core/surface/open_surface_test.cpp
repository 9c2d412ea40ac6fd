// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/open_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

SiteGeometry evenly(const Surface& surface, double spacing) {
  SiteGeometry geometry;
  geometry.spacing.assign(surface.positions.size(), spacing);
  return geometry;
}

TEST(OpenSurface, AGapIsTheDiameterOfTheSmallestCircleAroundAFace) {
  // Right, obtuse and equilateral.
  const Surface faces = test::surface_of(
      {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 1}, {2, 0, 1}, {1, 0.1, 1}, {1, std::sqrt(3), 1}},
      {{0, 1, 2}, {3, 4, 5}, {3, 4, 6}});
  SiteGeometry geometry = evenly(faces, 0.5);
  const std::vector<float> gaps = face_gaps(faces, geometry);
  EXPECT_FLOAT_EQ(gaps[0], 5 / 0.5F);
  EXPECT_FLOAT_EQ(gaps[1], 2 / 0.5F);
  EXPECT_FLOAT_EQ(gaps[2], 4 / std::sqrt(3.F) / 0.5F);
  geometry.spacing[1] = 1;  // the largest spacing of the corners counts
  EXPECT_FLOAT_EQ(face_gaps(faces, geometry)[0], 5);
  EXPECT_TRUE(is_narrow(faces, faces.triangles[1], geometry));
  EXPECT_FALSE(is_narrow(faces, faces.triangles[0], geometry));
}

TEST(OpenSurface, AGapHasTheSameBytesInAnyNumbering) {
  const Surface ball = test::ball();
  Surface turned = ball;
  for (Corners& t : turned.triangles) std::rotate(t.begin(), t.begin() + 1, t.end());
  EXPECT_EQ(face_gaps(ball, evenly(ball, 0.1)), face_gaps(turned, evenly(ball, 0.1)));
}

TEST(OpenSurface, BridgesGoAndManifoldsStayManifolds) {
  const Surface sheet = test::square_sheet(12, 1);
  test::Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<float> gaps(sheet.triangles.size());
    for (float& gap : gaps) gap = static_cast<float>(random.uniform(0, 9));
    Surface rest = sheet;
    remove_bridges(rest, gaps, evenly(sheet, 0.1));
    EXPECT_LT(rest.triangles.size(), sheet.triangles.size());
    ASSERT_FALSE(rest.triangles.empty());
    EXPECT_TRUE(test::check(rest).manifold());
    std::vector<char> used(rest.positions.size(), 0);
    for (const Corners& t : rest.triangles)
      for (Index v : t) used[v] = 1;
    EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);  // no vertex without a face
  }
}

TEST(OpenSurface, AGapAboveTheLowThresholdGoesOnlyBesideABridge) {
  const Surface sheet = test::square_sheet(6, 1);
  std::vector<float> gaps(sheet.triangles.size(), 1);
  gaps[30] = 6;
  Surface rest = sheet;
  remove_bridges(rest, gaps, evenly(sheet, 0.1));
  EXPECT_EQ(rest.triangles.size(), sheet.triangles.size());
  gaps[31] = 9;  // the other half of the same cell
  remove_bridges(rest, gaps, evenly(sheet, 0.1));
  EXPECT_EQ(rest.triangles.size(), sheet.triangles.size() - 2);
}

TEST(OpenSurface, OfSeveralFansAtAVertexTheLargestStays) {
  const Surface sheet = test::square_sheet(6, 1);
  std::vector<char> keep(sheet.triangles.size(), 1);
  const Index centre = 3 * 7 + 3;  // two of its six faces go, apart from each other
  std::vector<Index> around;
  for (Index t = 0; t < static_cast<Index>(keep.size()); ++t)
    if (std::count(sheet.triangles[t].begin(), sheet.triangles[t].end(), centre) > 0) around.push_back(t);
  ASSERT_EQ(around.size(), 6U);
  for (const Index first : around)
    for (const Index second : around) {
      keep.assign(keep.size(), 1);
      keep[first] = keep[second] = 0;
      Surface rest = sheet;
      keep_faces(rest, keep, evenly(sheet, 0.1));
      EXPECT_TRUE(test::check(rest).manifold());
      EXPECT_GE(rest.triangles.size() + 5, sheet.triangles.size());
    }
}

TEST(OpenSurface, TellsWhereSurfacesAreManifoldWithoutBridges) {
  // Two sheets that share one vertex, and a bridge face far wider than both.
  Surface sheet = test::square_sheet(3, 0.3);
  std::vector<Vec3> sites = sheet.positions;
  std::vector<Corners> triangles = sheet.triangles;
  const auto n = static_cast<Index>(sites.size());
  for (const Vec3& p : sheet.positions) sites.emplace_back(-p);
  for (Corners t : sheet.triangles) {
    for (Index& v : t) v = v == 0 ? 0 : v + n;
    triangles.push_back(t);
  }
  sites.emplace_back(9, 9, 9), sites.emplace_back(9, -9, 9);
  triangles.push_back({5, 2 * n, 2 * n + 1});
  SiteGeometry geometry;
  geometry.spacing.assign(sites.size(), 0.1);
  const std::vector<char> clean = manifold_without_bridges(triangles, sites, geometry);
  EXPECT_FALSE(clean[0]);      // two fans
  EXPECT_TRUE(clean[5]);       // the bridge face is gone
  EXPECT_FALSE(clean[2 * n]);  // no face is left
  for (Index v = 1; v < n; ++v) EXPECT_TRUE(clean[v]) << v;
}

}  // namespace
}  // namespace filmsticking
