// SPDX-License-Identifier: GPL-3.0-or-later
// What is done to clouds after they are read: precision, missing returns, several files as one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "io/cloud.h"
#include "io/field_role.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "io/merge.h"
#include "io/no_return.h"
#include "io/point_layout.h"
#include "samples.h"
#include "support/model.h"

namespace filmsticking::test {
namespace {

io::Cloud cloud_of(const std::vector<Point>& positions, const std::vector<io::Colour>& colours = {}) {
  return {io::make_cloud(positions, colours)};
}

/// A grid of 10 x 10 points, a step apart, in double precision.
std::vector<Point> grid(double step, const Point& origin) {
  std::vector<Point> points;
  for (int i = 0; i < 100; ++i)
    points.push_back({origin[0] + step * (i % 10), origin[1] + step * (i / 10), origin[2] + step * (i % 7)});
  return points;
}

TEST(Precision, IsSingleWhereThatTellsThePointsApart) {
  EXPECT_TRUE(io::float_suffices(io::make_cloud(grid(0.1, {0, 0, 0}))));
  EXPECT_TRUE(io::float_suffices(io::make_cloud(grid(1.0 / 3, {1.0 / 7, 0, 0}))));
  EXPECT_TRUE(io::float_suffices(io::make_cloud({})));
}

TEST(Precision, IsDoubleWherePointsWouldMove) {
  EXPECT_FALSE(io::float_suffices(io::make_cloud(grid(0.1, {483020, 5457020, 0}))));     // a house in UTM
  EXPECT_FALSE(io::float_suffices(io::make_cloud(grid(12.345, {483020, 5457020, 0}))));  // millimetres
  EXPECT_FALSE(io::float_suffices(io::make_cloud(grid(1.0 / 3, {1e6, 0, 0}))));
  // Two points so near that they would become one.
  std::vector<Point> near = grid(0.1, {0, 0, 0});
  near.push_back({near[99][0] + 1e-9, near[99][1], near[99][2]});
  EXPECT_FALSE(io::float_suffices(io::make_cloud(near)));
}

TEST(Precision, IsNotDecidedByPointsThatAreNotFinite) {
  std::vector<Point> points = grid(0.1, {0, 0, 0});
  points.push_back({NAN, 0.1, INFINITY});
  EXPECT_TRUE(io::float_suffices(io::make_cloud(points)));
}

TEST(Precision, RoundingKeepsAllOtherFields) {
  const std::vector<io::Colour> colours(100, {1, 2, 3});
  const pcl::PCLPointCloud2 rounded = io::with_float_positions(io::make_cloud(grid(0.1, {0, 0, 0}), colours));
  EXPECT_TRUE(io::PositionFields(rounded).single());
  EXPECT_EQ(io::colours_of(rounded), colours);
  EXPECT_EQ(io::positions_of(rounded)[11], (Point{0.1F, 0.1F, static_cast<float>(0.1 * 4)}));
}

TEST(NoReturn, AbsurdPointsAreFoundAtAnyDistance) {
  for (const double far : {1e6, 1e10, 3.4028234663852886e38, std::numeric_limits<double>::max(),
                           -std::numeric_limits<double>::infinity()}) {
    std::vector<Point> points = grid(0.1, {5, 5, 5});
    points.push_back({0, far, 0});
    const std::vector<bool> found = io::absurdly_far(points);
    EXPECT_TRUE(found[100]) << far;
    EXPECT_EQ(std::count(found.begin(), found.end(), true), 1) << far;
  }
  std::vector<Point> points = grid(0.1, {5, 5, 5});
  points.push_back({100, 5, 5});  // far, but somebody may have meant it
  EXPECT_FALSE(io::absurdly_far(points)[100]);
}

TEST(NoReturn, MissingHeightsAreNotFinite) {
  std::vector<Point> points = grid(3, {400000, 0, 250});
  points[7][2] = points[31][2] = -9999;
  pcl::PCLPointCloud2 cloud = io::make_cloud(points);
  EXPECT_EQ(io::mark_missing_heights(cloud), 2u);
  const std::vector<Point> left = io::positions_of(cloud);
  EXPECT_TRUE(std::isnan(left[7][2]) && std::isnan(left[31][0]));
  EXPECT_EQ(left[8], points[8]);
}

TEST(NoReturn, HeightsThatReachThereAreKept) {
  std::vector<Point> points = grid(3000, {0, 0, -9999});  // a trench, say, in millimetres
  pcl::PCLPointCloud2 cloud = io::make_cloud(points);
  EXPECT_EQ(io::mark_missing_heights(cloud), 0u);
  EXPECT_EQ(io::positions_of(cloud), points);
}

TEST(Merge, KeepsThePointsOfAllFilesInTheirOrder) {
  io::Cloud cloud = cloud_of({{1, 2, 3}}, {{1, 2, 3}});
  io::append(cloud, cloud_of({{0.1, 5, 6}, {7, 8, 9}}, {{4, 5, 6}, {7, 8, 9}}));
  EXPECT_EQ(io::positions_of(cloud.points), (std::vector<Point>{{1, 2, 3}, {0.1, 5, 6}, {7, 8, 9}}));
  EXPECT_EQ(io::colours_of(cloud.points), (std::vector<io::Colour>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
  EXPECT_TRUE(cloud.notes.empty());
}

TEST(Merge, SaysWhichFieldsItLeavesOut) {
  io::Cloud cloud = cloud_of({{1, 2, 3}}, {{1, 2, 3}});
  io::append(cloud, cloud_of({{4, 5, 6}}));
  EXPECT_TRUE(io::colours_of(cloud.points).empty());
  ASSERT_EQ(cloud.notes.size(), 1u);
  EXPECT_NE(cloud.notes[0].find("rgb"), std::string::npos);
}

TEST(Merge, EveryPointKeepsItsViewpoint) {
  io::Cloud cloud = cloud_of({{1, 2, 3}}), other = cloud_of({{4, 5, 6}}), third = cloud_of({{7, 8, 9}});
  cloud.viewpoint = Point{0, 0, 1};
  other.viewpoint = Point{0, 0, 2};
  third.viewpoint = Point{0, 0, 0.1};
  io::append(cloud, other);
  io::append(cloud, third);
  EXPECT_FALSE(cloud.viewpoint);
  EXPECT_EQ(cloud.viewpoints, (std::vector<Point>{{0, 0, 1}, {0, 0, 2}, {0, 0, 0.1}}));
}

TEST(Ptx, EveryPointKnowsItsStation) {
  const std::string axes = "1 0 0\n0 1 0\n0 0 1\n";
  const io::Cloud cloud = io::decode_cloud(
      "ptx", "1\n2\n0 0 0\n" + axes + "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n1 2 3 0.5\n0 0 0 0.5\n" +
                 "1\n1\n10 20 30\n" + axes + "1 0 0 0\n0 1 0 0\n0 0 1 0\n10 20 30 1\n1 2 3 0.5\n");
  EXPECT_EQ(cloud.viewpoints, (std::vector<Point>{{0, 0, 0}, {0, 0, 0}, {10, 20, 30}}));
  const std::vector<Point> points = io::positions_of(cloud.points);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0], (Point{1, 2, 3}));
  EXPECT_TRUE(std::isnan(points[1][0]));
  EXPECT_EQ(points[2], (Point{11, 22, 33}));
  // Meshes are seen from anywhere.
  EXPECT_EQ(io::encode_mesh("ply", io::make_mesh(cloud.points, {})).find("vp_x"), std::string::npos);
}

TEST(Las, MillimetresOfUtmAreTheNearestDoubles) {
  // 5457020.123 stored as 20123 thousandths behind 5457000.
  std::string bytes(227 + 20, '\0');
  bytes.replace(0, 4, "LASF");
  const auto put = [&](std::size_t at, auto value) { std::memcpy(&bytes[at], &value, sizeof value); };
  put(24, std::uint8_t{1}), put(25, std::uint8_t{2});
  put(94, std::uint16_t{227}), put(96, std::uint32_t{227}), put(105, std::uint16_t{20}),
      put(107, std::uint32_t{1});
  for (std::size_t k = 0; k < 3; ++k) put(131 + 8 * k, 0.001), put(155 + 8 * k, k == 1 ? 5457000.0 : 0.1);
  for (std::size_t k = 0; k < 3; ++k) put(227 + 4 * k, std::int32_t{20123});
  EXPECT_EQ(io::positions_of(io::decode_cloud("las", bytes).points),
            (std::vector<Point>{{20.223, 5457020.123, 20.223}}));
}

TEST(Roles, DoNotDependOnCaseUnitsAndQuotes) {
  using io::Role;
  for (const char* name : {"x", "X", "\"x\"", "x [m]", "X(mm)", "//X", "# x", "Easting", "Points:0"})
    EXPECT_EQ(io::role_of(name), Role::X) << name;
  EXPECT_EQ(io::role_of("Red"), Role::Red);
  EXPECT_EQ(io::role_of("diffuse_blue"), Role::Blue);
  for (const char* name : {"", "xx", "time", "redness"}) EXPECT_EQ(io::role_of(name), Role::Other) << name;
}

TEST(Layout, RIsNoColourWithoutGAndB) {
  const io::PointLayout layout({{"x"}, {"y"}, {"z"}, {"r"}});
  const pcl::PCLPointCloud2 cloud = layout.cloud(1);
  EXPECT_TRUE(io::find_field(cloud, "r"));
  EXPECT_FALSE(io::find_field(cloud, "rgb"));
}

TEST(Layout, ColoursOutOfRangeAreLeftOutWithANote) {
  const io::PointLayout layout({{"x"}, {"y"}, {"z"}, {"r"}, {"g"}, {"b"}});
  pcl::PCLPointCloud2 cloud = layout.cloud(1);
  const float wrong = -1;
  std::memcpy(&cloud.data[layout.offset(4)], &wrong, sizeof wrong);
  io::Notes notes;
  layout.finish(cloud, notes);
  EXPECT_FALSE(io::find_field(cloud, "rgb"));
  EXPECT_EQ(notes.size(), 1u);
}

TEST(Files, NewNormalsReplaceOldOnes) {
  const io::Cloud cloud = labelled(true);
  const std::vector<std::array<float, 3>> turned(4, {0, -1, 0});
  const pcl::PCLPointCloud2 again = io::with_normals(cloud.points, turned);
  EXPECT_EQ(again.fields.size(), cloud.points.fields.size());
  EXPECT_EQ(normals_in(again), turned);
  EXPECT_EQ(io::positions_of(again), io::positions_of(cloud.points));
}

TEST(Layout, ColoursHaveNamesThatBelongTogether) {
  const auto byte = io::Scalar::UInt8;
  const io::PointLayout radius(
      {{"x"}, {"y"}, {"z"}, {"r"}, {"red", byte}, {"green", byte}, {"blue", byte}, {"a"}});
  const pcl::PCLPointCloud2 cloud = radius.cloud(1);
  EXPECT_TRUE(io::find_field(cloud, "r"));
  EXPECT_TRUE(io::find_field(cloud, "a"));  // no alpha of red, green and blue
  EXPECT_TRUE(io::find_field(cloud, "rgb"));
}

TEST(Layout, AColumnWhoseNameAnotherHasIsLeftOutWithANote) {
  const io::PointLayout layout({{"x"}, {"y"}, {"z"}, {"x"}});
  pcl::PCLPointCloud2 cloud = layout.cloud(1);
  io::Notes notes;
  layout.finish(cloud, notes);
  EXPECT_EQ(notes.size(), 1u);
}

TEST(Clouds, StationsComeAndGoWithTheirBytes) {
  const pcl::PCLPointCloud2 plain = io::make_cloud({{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {1, 2, 3}});
  const std::vector<Point> stations = {{0, 0, 9}, {0, 0, -9}};
  const pcl::PCLPointCloud2 seen = io::with_stations(plain, stations);
  EXPECT_EQ(io::viewpoints_of(seen), stations);
  EXPECT_EQ(io::viewpoints_of(io::with_named_stations(seen)), stations);
  const pcl::PCLPointCloud2 again = io::without_stations(seen);
  EXPECT_EQ(again.data, plain.data);
  EXPECT_EQ(again.point_step, plain.point_step);
  EXPECT_EQ(io::positions_of(again), io::positions_of(plain));
  EXPECT_EQ(io::colours_of(again), io::colours_of(plain));
  EXPECT_TRUE(io::viewpoints_of(again).empty());
}

}  // namespace
}  // namespace filmsticking::test
