// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

TEST(Surface, OfSitesHasTheSitesOfItsTrianglesAsVertices) {
  std::vector<Vec3> sites;
  for (int i = 0; i < 8; ++i) sites.emplace_back(i, i * i, 1);
  const Surface surface = unsorted_surface_of_sites({{7, 2, 4}, {4, 2, 1}}, sites);
  EXPECT_EQ(surface.site, (std::vector<Index>{1, 2, 4, 7}));
  for (std::size_t v = 0; v < 4; ++v) EXPECT_EQ(surface.positions[v], sites[surface.site[v]]);
  EXPECT_EQ(surface.triangles, (std::vector<Corners>{{3, 1, 2}, {2, 1, 0}}));
}

TEST(Surface, OfSitesIsTheSameForAnyOrderOfTriangles) {
  const Surface ball = test::ball();
  std::vector<Corners> other = ball.triangles;
  std::reverse(other.begin(), other.end());
  for (Corners& t : other) std::rotate(t.begin(), t.begin() + 1, t.end());
  const Surface one = surface_of_sites(ball.triangles, ball.positions);
  EXPECT_EQ(one.triangles, surface_of_sites(other, ball.positions).triangles);
  EXPECT_TRUE(std::is_sorted(one.triangles.begin(), one.triangles.end()));
}

TEST(Surface, AreaVectorsOfAClosedSurfacePointOutwardAndAddUpToNothing) {
  const Surface ball = test::ball();
  Vec3 sum = Vec3::Zero();
  for (Index t = 0; t < static_cast<Index>(ball.triangles.size()); ++t) {
    EXPECT_GT(ball.area_vector2(t).dot(test::middle(ball, t)), 0);
    sum += ball.area_vector2(t);
  }
  EXPECT_NEAR(sum.norm(), 0, 1e-12);
}

TEST(Surface, CountsItsSites) {
  Surface surface;
  surface.site = {0, kNone, 3, 9, 4};
  EXPECT_EQ(sites_on(surface, 4), 2);
  EXPECT_EQ(sites_on(surface, 10), 4);
}

}  // namespace
}  // namespace filmsticking
