// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/viewpoint.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "film/initial_surface.h"
#include "support/surfaces.h"

namespace filmsticking {
namespace {

// Squares across z, some turned to -z, bent so that +z is their convex side.
Surface squares(const std::vector<std::pair<Vec3, bool>>& places, double side) {
  std::vector<Vec3> positions;
  std::vector<Corners> triangles;
  for (const auto& [place, back] : places) {
    const auto n = static_cast<Index>(positions.size());
    for (const Vec3& p :
         {Vec3(0, 0, 0), Vec3(side, 0, -side / 4), Vec3(side, side, 0), Vec3(0, side, -side / 4)})
      positions.push_back(place + p);
    for (Corners t : {Corners{n, n + 1, n + 2}, Corners{n, n + 2, n + 3}}) {
      if (back) std::swap(t[1], t[2]);
      triangles.push_back(t);
    }
  }
  return test::surface_of(std::move(positions), std::move(triangles));
}

Index turned(Surface& surface) {
  return turn_to_viewpoint(surface,
                           SurfaceTopology(surface.triangles, static_cast<Index>(surface.positions.size())));
}

TEST(Viewpoint, SeesTheFrontsOfAllPieces) {
  for (const bool back : {false, true}) {
    Surface surface = squares({{{0, 0, 0}, back}, {{-0.3, 0.1, -0.5}, true}, {{0.9, 0, -0.2}, false}}, 0.25);
    surface.positions[2] += Vec3(1e-3, 1e-3, 0);  // the first is the largest
    EXPECT_EQ(turned(surface), 1 + back);
    for (Index t = 0; t < 6; ++t) EXPECT_GT(surface.area_vector2(t).z(), 0) << t;
    EXPECT_EQ(turned(surface), 0);
  }
}

// Three sides of a box, one with most of the faces, of which half are turned over: all three are seen, not
// just the one from straight ahead.
TEST(Viewpoint, IsInViewOfAllThatCanBeSeenWhicheverWayItIsTurned) {
  for (const bool some_turned : {false, true}) {
    std::vector<Vec3> positions, outward;
    std::vector<Corners> triangles;
    for (int side = 0; side < 3; ++side) {
      const auto first = static_cast<Index>(positions.size());
      const int n = side == 0 ? 24 : 8;
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
          positions.push_back(Vec3::Ones());
          positions.back()[(side + 1) % 3] -= i / 16.0, positions.back()[(side + 2) % 3] -= j / 16.0;
        }
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const Index a = first + i * (n + 1) + j, b = a + n + 1;
          for (Corners t : {Corners{a, b, b + 1}, Corners{a, b + 1, a + 1}}) {
            if (some_turned && i >= n / 2) std::swap(t[1], t[2]);
            triangles.push_back(t);
            outward.emplace_back(Vec3::Unit(side));
          }
        }
    }
    const Surface surface = test::surface_of(std::move(positions), std::move(triangles));
    const Vec3 eye = common_viewpoint(surface);
    EXPECT_TRUE(is_seen_once(surface, eye));
    EXPECT_NEAR(turned_away_share(surface, eye), some_turned ? 0.5 : 0, 1e-9);
    // From before all three or from behind them.
    std::size_t before = 0;
    for (std::size_t t = 0; t < outward.size(); ++t)
      before += outward[t].dot(eye - surface.corner(static_cast<Index>(t), 0)) > 0;
    EXPECT_TRUE(before == 0 || before == outward.size()) << before << " of " << outward.size();
  }
}

// All of its bends are right angles, which were taken for folds.
TEST(Viewpoint, Regression_ABoxShowsItsOutside) {
  // A cube's sides but the one at z = 0, each of two faces.
  std::vector<Vec3> positions;
  for (int i = 0; i < 8; ++i) positions.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  const std::vector<Corners> outward = {{4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4}, {1, 3, 7},
                                        {1, 7, 5}, {3, 2, 6}, {3, 6, 7}, {2, 0, 4}, {2, 4, 6}};
  for (const bool inward : {false, true}) {
    std::vector<Corners> triangles = outward;
    if (inward)
      for (Corners& t : triangles) std::swap(t[1], t[2]);
    Surface surface = test::surface_of(positions, std::move(triangles));
    EXPECT_EQ(turned(surface), inward ? 1 : 0);
    EXPECT_GT(surface.area_vector2(0).z(), 0);
  }
}

TEST(Viewpoint, SeesABallTwiceAndHalfOfItOnce) {
  const Surface ball = bounding_sphere({Vec3(0.5, 0.5, 0.5)});
  EXPECT_FALSE(is_seen_once(ball, common_viewpoint(ball)));
  EXPECT_FALSE(is_seen_once(ball, Vec3(0, 0, 9)));
  Surface half = ball;
  half.triangles.clear();
  for (const Corners& t : ball.triangles)
    if ((ball.positions[t[0]] + ball.positions[t[1]] + ball.positions[t[2]]).z() > 0)
      half.triangles.push_back(t);
  EXPECT_TRUE(is_seen_once(half, Vec3(0, 0, 9)));
  EXPECT_FALSE(is_seen_once(half, Vec3(9, 0, 0)));
  EXPECT_LE(odd_crossing_share(ball, Vec3(0, 0, 9)), 0.01);  // a line may meet a vertex
  EXPECT_GE(odd_crossing_share(half, Vec3(0, 0, 9)), 0.8);   // and the rim goes to and fro
  EXPECT_NEAR(turned_away_share(half, Vec3(0, 0, 99)), 0, 0.02);
  EXPECT_NEAR(turned_away_share(half, Vec3(99, 0, 0)), 0.5, 0.02);
}

TEST(Viewpoint, OfNothingIsNoMatter) {
  const Surface none;
  EXPECT_TRUE(common_viewpoint(none).allFinite());
  EXPECT_TRUE(is_seen_once(none, Vec3::Zero()));
  EXPECT_EQ(odd_crossing_share(none, Vec3::Zero()), 0);
  EXPECT_EQ(turned_away_share(none, Vec3::Zero()), 0);
}

// All sides of a ball but a part of one: no point sees them.
TEST(Viewpoint, TurnsNoOtherWhereThereIsNone) {
  Surface surface = squares({{{2, 0, 0}, true}}, 0.25);
  const Surface ball = bounding_sphere({Vec3(0.5, 0.5, 0.5)});
  std::vector<Vec3> positions = surface.positions;
  std::vector<Corners> triangles = surface.triangles;
  const auto first = static_cast<Index>(positions.size());
  positions.insert(positions.end(), ball.positions.begin(), ball.positions.end());
  for (std::size_t t = 1; t < ball.triangles.size(); ++t) {
    Corners c = ball.triangles[t];
    for (Index& v : c) v += first;
    triangles.push_back(c);
  }
  surface = test::surface_of(std::move(positions), std::move(triangles));
  EXPECT_EQ(turned(surface), 0);
  EXPECT_LT(surface.area_vector2(0).z(), 0);
}

}  // namespace
}  // namespace filmsticking
