// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream/live_accumulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "stream/live_frame.h"
#include "support/clouds.h"

namespace filmsticking::stream {
namespace {

io::Model frame_of(std::vector<Point> points) { return {std::move(points), {}, {}}; }

/// n points on a line along x, one unit apart, at that height.
io::Model line(int n, double height) {
  io::Model model;
  for (int x = 0; x < n; ++x) model.positions.push_back({x + 0.5, 0.5, height});
  return model;
}

std::set<Point> points_of(const Accumulator& accumulator) {
  const io::Model cloud = accumulator.cloud();
  return {cloud.positions.begin(), cloud.positions.end()};
}

TEST(Accumulator, HoldsTheNewestFramesOnly) {
  Accumulator accumulator;
  accumulator.set_bounds({0, 2, 1000});
  for (const double height : {1, 2, 3}) accumulator.add(line(4, height));
  EXPECT_EQ(accumulator.size(), 8u);
  for (const Point& p : points_of(accumulator)) EXPECT_GE(p[2], 2);

  accumulator.set_bounds({0, 1, 1000});
  EXPECT_EQ(accumulator.size(), 4u);
  accumulator.clear();
  EXPECT_EQ(accumulator.size(), 0u);
  EXPECT_TRUE(accumulator.cloud().positions.empty());
}

TEST(Accumulator, HoldsAllFramesIfNoWindowIsSet) {
  Accumulator accumulator;
  accumulator.set_bounds({0, 0, 1000});
  for (int frame = 0; frame < 20; ++frame) accumulator.add(line(5, frame));
  EXPECT_EQ(accumulator.size(), 100u);
  EXPECT_EQ(accumulator.given_up(), 0);
}

TEST(Accumulator, ACellKeepsTheFirstPointOfTheNewestFrame) {
  Accumulator accumulator;
  accumulator.set_bounds({1, 0, 1000});
  accumulator.add(frame_of({{0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}, {-0.25, 0.5, 0.5}}));
  EXPECT_EQ(points_of(accumulator), (std::set<Point>{{0.25, 0.5, 0.5}, {-0.25, 0.5, 0.5}}));
  accumulator.add(frame_of({{0.625, 0.5, 0.5}, {0.125, 0.5, 0.5}}));
  EXPECT_EQ(points_of(accumulator), (std::set<Point>{{0.625, 0.5, 0.5}, {-0.25, 0.5, 0.5}}));
}

TEST(Accumulator, AWindowForgetsWhatWasNotSeenAgain) {
  Accumulator accumulator;
  accumulator.set_bounds({1, 3, 1000});
  accumulator.add(line(10, 0));
  for (int frame = 0; frame < 3; ++frame) accumulator.add(line(6, 0));
  EXPECT_EQ(accumulator.size(), 6u);  // four were seen in the first frame only
}

TEST(Accumulator, GivesTheOldestFramesUp) {
  Accumulator accumulator;
  accumulator.set_bounds({0, 0, 25});
  for (const double height : {1, 2, 3}) accumulator.add(line(10, height));
  EXPECT_EQ(accumulator.size(), 20u);
  EXPECT_EQ(accumulator.given_up(), 10);
  for (const Point& p : points_of(accumulator)) EXPECT_GE(p[2], 2);
}

TEST(Accumulator, ThinsAFrameThatIsTooLargeEvenly) {
  Accumulator accumulator;
  accumulator.set_bounds({0, 0, 100});
  accumulator.add(line(1000, 0));
  ASSERT_EQ(accumulator.size(), 100u);
  EXPECT_EQ(accumulator.given_up(), 900);
  double before = -0.5;
  for (const Point& p : accumulator.cloud().positions) {
    EXPECT_NEAR(p[0] - before, 10, 1);
    before = p[0];
  }
}

TEST(Accumulator, NeverHoldsMoreThanItMay) {
  test::Random random(7);
  Accumulator accumulator;
  std::size_t most = 100;
  accumulator.set_bounds({0.1, 5, most});
  for (int frame = 0; frame < 400; ++frame) {
    if (random.below(10) == 0) {
      most = 4 + static_cast<std::size_t>(random.below(300));
      accumulator.set_bounds({random.below(2) * 0.2, random.below(6), most});
    }
    accumulator.add(frame_of(test::awkward(static_cast<std::uint64_t>(frame))));
    ASSERT_LE(accumulator.size(), most);
    ASSERT_EQ(accumulator.cloud().positions.size(), accumulator.size());
  }
}

TEST(Accumulator, LeavesOutWhatIsNotFiniteInSinglePrecision) {
  Accumulator accumulator;
  accumulator.add(frame_of({{NAN, 0, 0}, {0, INFINITY, 0}, {0, 0, 1e300}, {1, 2, 3}}));
  EXPECT_EQ(points_of(accumulator), (std::set<Point>{{1, 2, 3}}));
}

TEST(Accumulator, RoundsToSinglePrecision) {
  Accumulator accumulator;
  accumulator.add(frame_of({{0.1, 0.2, 0.3}}));
  EXPECT_EQ(points_of(accumulator), (std::set<Point>{{0.1f, 0.2f, 0.3f}}));
}

TEST(Accumulator, HasColoursIfAllPointsHave) {
  Accumulator accumulator;
  accumulator.set_bounds({0, 2, 1000});
  io::Model coloured = line(2, 0);
  coloured.colours = {{1, 2, 3}, {4, 5, 6}};
  accumulator.add(coloured);
  EXPECT_EQ(accumulator.cloud().colours, coloured.colours);
  accumulator.add(line(2, 1));
  EXPECT_TRUE(accumulator.cloud().colours.empty());
  accumulator.add(coloured);
  accumulator.add(coloured);
  EXPECT_EQ(accumulator.cloud().colours.size(), 4u);
}

TEST(Frame, KeepsWhatIsInRangeWithItsColour) {
  io::Model frame{{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, {}};
  keep_range(frame, 1.5, 2.5);
  EXPECT_EQ(frame.positions, (std::vector<Point>{{0, 2, 0}}));
  EXPECT_EQ(frame.colours, (std::vector<io::Colour>{{2, 2, 2}}));
  keep_range(frame, 0, 0);
  EXPECT_EQ(frame.positions.size(), 1u);
}

TEST(Frame, MovesAsThePoseTells) {
  io::Model frame = frame_of({{1, 0, 0}});
  frame.viewpoint = Point{0, 0, 0};
  Pose pose = Pose::Identity();
  pose.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // a quarter turn about z
  pose.translation() << 10, 20, 30;
  move(frame, pose);
  EXPECT_EQ(frame.positions[0], (Point{10, 21, 30}));
  EXPECT_EQ(frame.viewpoint, (Point{10, 20, 30}));
  Accumulator accumulator;
  accumulator.add(frame);
  EXPECT_EQ(accumulator.cloud().viewpoint, frame.viewpoint);
}

}  // namespace
}  // namespace filmsticking::stream
