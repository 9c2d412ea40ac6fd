// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream/frame_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/cloud.h"
#include "io/io_error.h"
#include "poses.h"
#include "stream/stream_error.h"

namespace filmsticking::stream {
namespace {

Frame frame_of(const std::vector<Point>& points, const std::vector<io::Colour>& colours = {}) {
  Frame frame;
  frame.cloud = io::make_cloud(points, colours);
  return frame;
}

TEST(FramePoints, AreFiniteAndPassTheFilters) {
  const Frame frame = frame_of({{1, 0, 0}, {NAN, 0, 0}, {3, 0, 0}}, {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}});
  const pcl::PCLPointCloud2 all = frame_points(frame, {});
  EXPECT_EQ(io::positions_of(all), (std::vector<Point>{{1, 0, 0}, {3, 0, 0}}));
  EXPECT_EQ(io::colours_of(all), (std::vector<io::Colour>{{1, 1, 1}, {3, 3, 3}}));
  filters::FilterOptions filters;
  filters.crop = filters::Box{{2, -1, -1}, {4, 1, 1}};
  EXPECT_EQ(io::positions_of(frame_points(frame, filters)), (std::vector<Point>{{3, 0, 0}}));
  filters.crop = filters::Box{{5, -1, -1}, {6, 1, 1}};
  EXPECT_THROW(frame_points(frame, filters), StreamError);
  EXPECT_THROW(frame_points(Frame(), {}), StreamError);
}

TEST(FramePoints, InRangeKeepTheirFields) {
  const Frame frame = frame_of({{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}});
  const pcl::PCLPointCloud2 kept = in_range(frame.cloud, 1.5, 2.5);
  EXPECT_EQ(io::positions_of(kept), (std::vector<Point>{{0, 2, 0}}));
  EXPECT_EQ(io::colours_of(kept), (std::vector<io::Colour>{{2, 2, 2}}));
  EXPECT_EQ(io::size_of(in_range(frame.cloud, 0, 0)), 3u);
  pcl::PCLPointCloud2 without_positions = frame.cloud;
  without_positions.fields.clear();
  EXPECT_THROW(in_range(without_positions, 0, 0), io::IoError);
}

TEST(FramePoints, MoveAsThePoseSays) {
  const std::vector<Point> to = moved({{1, 0, 0}, {0, 0, 2}}, pose(10, 20, 30, M_PI / 2, {0, 0, 1}));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(to[0][axis], (Point{10, 21, 30})[axis], 1e-12);
    EXPECT_NEAR(to[1][axis], (Point{10, 20, 32})[axis], 1e-12);
  }
}

TEST(FramePoints, TheSpacingOfAGridIsItsPitchAlsoFarFromTheOrigin) {
  std::vector<Point> grid;
  for (int x = 0; x < 50; ++x)
    for (int y = 0; y < 50; ++y) grid.push_back({5e6 + 0.25 * x, 0.25 * y, 0});
  EXPECT_NEAR(mean_spacing(grid), 0.25, 1e-6);
  EXPECT_EQ(mean_spacing({{1, 2, 3}}), 0);
  EXPECT_EQ(mean_spacing({{1, 2, 3}, {1, 2, 3}}), 0);
}

}  // namespace
}  // namespace filmsticking::stream
