// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream/mean_cloud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "support/clouds.h"

namespace filmsticking::stream {
namespace {

TEST(MeanCloud, GivesTheMeanOfEachCell) {
  test::Random random(1);
  MeanCloud fused(0.5, 1000);
  std::map<std::array<int, 3>, std::pair<Point, int>> cells;
  for (int frame = 0; frame < 3; ++frame) {
    std::vector<Point> points;
    for (int i = 0; i < 500; ++i) {
      const Point p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      points.push_back(p);
      auto& [sum, count] =
          cells[{int(std::floor(p[0] * 2)), int(std::floor(p[1] * 2)), int(std::floor(p[2] * 2))}];
      for (int axis = 0; axis < 3; ++axis) sum[axis] += p[axis];
      ++count;
    }
    points.push_back({NAN, 0, 0});
    points.push_back({1e300, 0, 0});
    fused.add(points);
  }
  ASSERT_EQ(fused.size(), cells.size());
  for (const Point& p : fused.positions()) {
    const auto& [sum, count] =
        cells.at({int(std::floor(p[0] * 2)), int(std::floor(p[1] * 2)), int(std::floor(p[2] * 2))});
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(p[axis], sum[axis] / count, 1e-12);
  }
}

TEST(MeanCloud, GetsCoarserInsteadOfLarger) {
  const std::vector<Point> points = test::sphere(20000, 2);
  MeanCloud small(0.01, 1000);
  small.add(points);
  EXPECT_LE(small.size(), 1000u);
  EXPECT_GT(small.size(), 200u);
  const double factor = small.width() / 0.01;
  EXPECT_EQ(factor, std::exp2(std::round(std::log2(factor))));
  // The same cells as those of a cloud that was as coarse from the start.
  MeanCloud same(small.width(), 1000000);
  same.add(points);
  ASSERT_EQ(same.size(), small.size());
  std::map<std::array<long, 3>, Point> mean;
  const auto cell = [&](const Point& p) {
    return std::array<long, 3>{std::lround(std::floor(p[0] / small.width())),
                               std::lround(std::floor(p[1] / small.width())),
                               std::lround(std::floor(p[2] / small.width()))};
  };
  for (const Point& p : same.positions()) mean[cell(p)] = p;
  for (const Point& p : small.positions())
    for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(p[axis], mean.at(cell(p))[axis], 1e-12);
}

TEST(MeanCloud, CountsFramesAndMixesColours) {
  MeanCloud fused(1, 100);
  fused.add({{0.5, 0.5, 0.5}, {0.6, 0.5, 0.5}, {2.5, 0, 0}}, {{0, 10, 255}, {0, 10, 255}, {1, 1, 1}});
  EXPECT_EQ(fused.positions(2).size(), 0u);  // two points of one frame are one frame
  fused.add({{0.7, 0.5, 0.5}, {0.6, 0.5, 0.5}}, {{200, 10, 255}, {200, 10, 255}});
  const pcl::PCLPointCloud2 twice = fused.cloud(2);
  const std::vector<Point> positions = io::positions_of(twice);
  ASSERT_EQ(positions.size(), 1u);
  EXPECT_NEAR(positions[0][0], 0.6, 1e-12);
  EXPECT_EQ(positions, fused.positions(2));  // in double precision
  EXPECT_EQ(io::colours_of(twice)[0], (io::Colour{100, 10, 255}));
  fused.add({{9, 9, 9}});  // without a colour
  EXPECT_TRUE(io::colours_of(fused.cloud()).empty());
}

TEST(MeanCloud, ACellKeepsTheNearestOfItsSensors) {
  const Point near{0, 0, 2}, far{0, 0, -9};
  for (const bool near_first : {true, false}) {
    MeanCloud fused(1, 100);
    for (const bool is_near : {near_first, !near_first})
      fused.add({{0.5, 0.5, is_near ? 0.6 : 0.4}, {is_near ? 3.5 : 5.5, 0.5, 0.5}}, {}, is_near ? near : far);
    fused.add({{9.5, 0.5, 0.5}});  // nobody knows from where
    const std::vector<Point> points = fused.positions(), sensors = io::viewpoints_of(fused.cloud());
    ASSERT_EQ(sensors.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      if (points[i][0] > 9) {
        EXPECT_TRUE(std::isnan(sensors[i][0]));
      } else {
        EXPECT_EQ(sensors[i], points[i][0] > 5 ? far : near) << points[i][0];
      }
    }
    EXPECT_EQ(io::viewpoints_of(fused.cloud(2)), std::vector<Point>{near});
  }
}

TEST(MeanCloud, CoarserCellsKeepTheNearestSensorToo) {
  MeanCloud fused(1, 1);
  fused.add({{0.5, 0.5, 0.5}}, {}, Point{0, 0, -9});
  fused.add({{1.5, 1.5, 1.5}}, {}, Point{0, 0, 2});
  ASSERT_EQ(fused.size(), 1u);
  EXPECT_EQ(io::viewpoints_of(fused.cloud()), (std::vector<Point>{{0, 0, 2}}));
}

}  // namespace
}  // namespace filmsticking::stream
