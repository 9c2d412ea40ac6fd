// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream/newest_cloud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>

#include "io/cloud.h"
#include "poses.h"
#include "support/clouds.h"

namespace filmsticking::stream {
namespace {

Frame frame_of(const std::vector<Point>& points, const std::vector<io::Colour>& colours = {}) {
  Frame frame;
  frame.cloud = io::make_cloud(points, colours);
  return frame;
}

/// n points on a line along x, one unit apart, at that height.
Frame line(int n, double height) {
  std::vector<Point> points;
  for (int x = 0; x < n; ++x) points.push_back({x + 0.5, 0.5, height});
  return frame_of(points);
}

std::vector<Point> points_of(const NewestCloud& cloud) { return io::positions_of(cloud.cloud()); }

std::set<Point> set_of(const NewestCloud& cloud) {
  const std::vector<Point> points = points_of(cloud);
  return {points.begin(), points.end()};
}

TEST(NewestCloud, HoldsTheNewestFramesOnly) {
  NewestCloud cloud;
  cloud.set_bounds({0, 2, 1000});
  for (const double height : {1, 2, 3}) cloud.add(line(4, height));
  EXPECT_EQ(cloud.size(), 8u);
  for (const Point& p : set_of(cloud)) EXPECT_GE(p[2], 2);

  cloud.set_bounds({0, 1, 1000});
  EXPECT_EQ(cloud.size(), 4u);
  cloud.clear();
  EXPECT_EQ(cloud.size(), 0u);
  EXPECT_TRUE(points_of(cloud).empty());
}

TEST(NewestCloud, HoldsAllFramesIfNoWindowIsSet) {
  NewestCloud cloud;
  cloud.set_bounds({0, 0, 1000});
  for (int frame = 0; frame < 20; ++frame) cloud.add(line(5, frame));
  EXPECT_EQ(cloud.size(), 100u);
  EXPECT_EQ(cloud.given_up(), 0);
}

TEST(NewestCloud, ACellKeepsTheFirstPointOfTheNewestFrame) {
  NewestCloud cloud;
  cloud.set_bounds({1, 0, 1000});
  cloud.add(frame_of({{0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}, {-0.25, 0.5, 0.5}}));
  EXPECT_EQ(set_of(cloud), (std::set<Point>{{0.25, 0.5, 0.5}, {-0.25, 0.5, 0.5}}));
  cloud.add(frame_of({{0.625, 0.5, 0.5}, {0.125, 0.5, 0.5}}));
  EXPECT_EQ(set_of(cloud), (std::set<Point>{{0.625, 0.5, 0.5}, {-0.25, 0.5, 0.5}}));
}

TEST(NewestCloud, AWindowForgetsWhatWasNotSeenAgain) {
  NewestCloud cloud;
  cloud.set_bounds({1, 3, 1000});
  cloud.add(line(10, 0));
  for (int frame = 0; frame < 3; ++frame) cloud.add(line(6, 0));
  EXPECT_EQ(cloud.size(), 6u);  // four were seen in the first frame only
}

TEST(NewestCloud, GivesTheOldestFramesUp) {
  NewestCloud cloud;
  cloud.set_bounds({0, 0, 25});
  for (const double height : {1, 2, 3}) cloud.add(line(10, height));
  EXPECT_EQ(cloud.size(), 20u);
  EXPECT_EQ(cloud.given_up(), 10);
  for (const Point& p : set_of(cloud)) EXPECT_GE(p[2], 2);
}

TEST(NewestCloud, ThinsAFrameThatIsTooLargeEvenly) {
  NewestCloud cloud;
  cloud.set_bounds({0, 0, 100});
  cloud.add(line(1000, 0));
  ASSERT_EQ(cloud.size(), 100u);
  EXPECT_EQ(cloud.given_up(), 900);
  double before = -0.5;
  for (const Point& p : points_of(cloud)) {
    EXPECT_NEAR(p[0] - before, 10, 1);
    before = p[0];
  }
}

TEST(NewestCloud, NeverHoldsMoreThanItMay) {
  test::Random random(7);
  NewestCloud cloud;
  std::size_t most = 100;
  cloud.set_bounds({0.1, 5, most});
  for (int frame = 0; frame < 400; ++frame) {
    if (random.below(10) == 0) {
      most = 4 + static_cast<std::size_t>(random.below(300));
      cloud.set_bounds({random.below(2) * 0.2, random.below(6), most});
    }
    cloud.add(frame_of(test::awkward(static_cast<std::uint64_t>(frame))));
    ASSERT_LE(cloud.size(), most);
    ASSERT_EQ(points_of(cloud).size(), cloud.size());
  }
}

TEST(NewestCloud, LeavesOutWhatIsNotFiniteInSinglePrecision) {
  NewestCloud cloud;
  cloud.add(frame_of({{NAN, 0, 0}, {0, INFINITY, 0}, {0, 0, 1e300}, {1, 2, 3}}));
  EXPECT_EQ(set_of(cloud), (std::set<Point>{{1, 2, 3}}));
}

TEST(NewestCloud, MovesPointsAndRoundsThemToSinglePrecision) {
  Frame frame = frame_of({{0.1, 0.2, 0.3}});
  NewestCloud cloud;
  cloud.add(frame);
  EXPECT_EQ(points_of(cloud), (std::vector<Point>{{0.1f, 0.2f, 0.3f}}));

  frame = frame_of({{1, 0, 0}});
  frame.sensor_pose.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // a quarter turn about z
  frame.sensor_pose.translation() << 10, 20, 30;
  cloud.add(frame);
  EXPECT_EQ(points_of(cloud), (std::vector<Point>{{10, 21, 30}}));
}

TEST(NewestCloud, EachPointKeepsWhereItWasSeenFrom) {
  NewestCloud cloud;
  cloud.set_bounds({1, 0, 1000});
  Frame front = line(4, -9.5), back = line(6, 10.25);  // of the cells, the back sees two more
  front.sensor_pose.translation() << 0, 0, 10;
  back.sensor_pose.translation() << 0, 0, -10;
  cloud.add(back);
  cloud.add(front);
  const std::vector<Point> sensors = io::viewpoints_of(cloud.cloud()), points = points_of(cloud);
  ASSERT_EQ(sensors.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(sensors[i], (Point{0, 0, points[i][2] == 0.5 ? 10.0 : -10.0})) << points[i][2];
}

TEST(NewestCloud, SensorsThatAFrameNamesMoveWithIt) {
  Frame frame;
  frame.cloud = io::with_named_stations(
      io::with_stations(io::make_cloud({{1, 2, 3}, {4, 5, 6}}), {{0, 0, 1}, {0, 0, 2}}));
  frame.sensor_pose.translation() << 10, 20, 30;
  NewestCloud cloud;
  cloud.add(frame);
  EXPECT_EQ(io::viewpoints_of(cloud.cloud()), (std::vector<Point>{{10, 20, 31}, {10, 20, 32}}));
}

/// The points with a field "ring" whose values count from `first`.
Frame with_rings(const Frame& frame, std::uint16_t first) {
  Frame with;
  std::vector<pcl::PCLPointField> fields = frame.cloud.fields;
  const std::size_t step = frame.cloud.point_step;
  fields.push_back(io::make_field("ring", step, pcl::PCLPointField::UINT16));
  with.cloud = io::make_rows(fields, step + 2, frame.cloud.width);
  for (std::size_t i = 0; i < frame.cloud.width; ++i, ++first) {
    std::uint8_t* to = &with.cloud.data[i * with.cloud.point_step];
    std::memcpy(to, io::bytes_of(frame.cloud, i), step);
    std::memcpy(to + step, &first, sizeof first);
  }
  return with;
}

std::vector<std::uint16_t> rings_of(const pcl::PCLPointCloud2& cloud) {
  std::vector<std::uint16_t> values(cloud.width);
  const pcl::PCLPointField* field = io::find_field(cloud, "ring");
  for (std::size_t i = 0; i < values.size(); ++i)
    std::memcpy(&values[i], &cloud.data[i * cloud.point_step + field->offset], 2);
  return values;
}

TEST(NewestCloud, KeepsEveryField) {
  NewestCloud cloud;
  cloud.set_bounds({0, 2, 1000});
  cloud.add(with_rings(frame_of({{1, 2, 3}, {4, 5, 6}}, {{1, 2, 3}, {4, 5, 6}}), 7));
  cloud.add(with_rings(frame_of({{7, 8, 9}}, {{7, 8, 9}}), 500));
  EXPECT_EQ(rings_of(cloud.cloud()), (std::vector<std::uint16_t>{7, 8, 500}));
  EXPECT_EQ(io::colours_of(cloud.cloud()), (std::vector<io::Colour>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
  EXPECT_EQ(points_of(cloud), (std::vector<Point>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
}

TEST(NewestCloud, HasTheFieldsThatAllHeldFramesHave) {
  NewestCloud cloud;
  cloud.set_bounds({0, 2, 1000});
  const std::vector<io::Colour> colours = {{1, 2, 3}, {4, 5, 6}};
  const std::vector<Point> points = {{1, 2, 3}, {4, 5, 6}};
  const Frame coloured = with_rings(frame_of(points, colours), 1);
  const Frame plain = with_rings(frame_of(points), 3);
  cloud.add(coloured);
  EXPECT_EQ(io::colours_of(cloud.cloud()), colours);
  cloud.add(plain);
  EXPECT_TRUE(io::colours_of(cloud.cloud()).empty());
  EXPECT_EQ(rings_of(cloud.cloud()), (std::vector<std::uint16_t>{1, 2, 3, 4}));
  cloud.add(coloured);
  EXPECT_TRUE(io::colours_of(cloud.cloud()).empty());
  cloud.add(coloured);  // the plain frame has left the window
  EXPECT_EQ(io::colours_of(cloud.cloud()).size(), 4u);
  EXPECT_EQ(rings_of(cloud.cloud()), (std::vector<std::uint16_t>{1, 2, 1, 2}));
}

}  // namespace
}  // namespace filmsticking::stream
