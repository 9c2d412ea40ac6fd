// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversions.h"

#include <geometry_msgs/Transform.h>
#include <gtest/gtest.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/Marker.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "stream/frame_points.h"
#include "stream/newest_cloud.h"
#include "support/clouds.h"

namespace filmsticking::stream {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

pcl::PolygonMesh tetrahedron() {
  pcl::PolygonMesh mesh;
  mesh.cloud = io::make_cloud({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                              {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {1, 2, 3}});
  mesh.polygons = io::polygons_of({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  return mesh;
}

/// The message of a cloud with x, y, z, rgb.
PointCloud2 message() {
  PointCloud2 message;
  pcl_conversions::fromPCL(tetrahedron().cloud, message);
  return message;
}

/// Reads a message as the node does.
std::vector<Point> read(const PointCloud2& message) {
  return io::positions_of(in_range(to_cloud(message), 0, 0));
}

void add_field(PointCloud2& cloud, const std::string& name, std::uint32_t offset, std::uint8_t type) {
  PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = type;
  field.count = 1;
  cloud.fields.push_back(field);
}

/// Two rows of two points in double precision with padding after points and rows; one is not finite.
PointCloud2 padded(bool big_endian) {
  PointCloud2 cloud;
  add_field(cloud, "intensity", 0, PointField::FLOAT32);
  add_field(cloud, "z", 8, PointField::FLOAT64);
  add_field(cloud, "y", 16, PointField::FLOAT64);
  add_field(cloud, "x", 24, PointField::FLOAT64);
  add_field(cloud, "rgba", 32, PointField::UINT32);
  cloud.width = cloud.height = 2;
  cloud.point_step = 40;
  cloud.row_step = 100;
  cloud.is_bigendian = big_endian;
  cloud.data.resize(200, 0xab);
  const auto store = [&](std::size_t offset, auto value) {
    auto* bytes = reinterpret_cast<std::uint8_t*>(&value);
    if (big_endian) std::reverse(bytes, bytes + sizeof value);
    std::copy(bytes, bytes + sizeof value, cloud.data.begin() + static_cast<std::ptrdiff_t>(offset));
  };
  for (std::size_t row = 0; row < 2; ++row)
    for (std::size_t column = 0; column < 2; ++column) {
      const std::size_t point = 100 * row + 40 * column;
      store(point, 0.5f + static_cast<float>(column));
      store(point + 24, row == 1 && column == 0 ? std::nan("") : 0.1 + static_cast<double>(column));
      store(point + 16, 0.2 + static_cast<double>(row));
      store(point + 8, -3.0);
      store(point + 32, std::uint32_t{0xff0a141e} + static_cast<std::uint32_t>(column));
    }
  return cloud;
}

TEST(Conversions, ReadsAnyLayoutWithAllFields) {
  for (const bool big_endian : {false, true}) {
    Frame frame;
    frame.cloud = to_cloud(padded(big_endian));
    NewestCloud held;
    held.add(frame);
    const pcl::PCLPointCloud2 cloud = held.cloud();
    EXPECT_EQ(io::positions_of(cloud),
              (std::vector<Point>{{0.1f, 0.2f, -3}, {1.1f, 0.2f, -3}, {1.1f, 1.2f, -3}}));
    EXPECT_EQ(io::colours_of(cloud), (std::vector<io::Colour>{{10, 20, 30}, {10, 20, 31}, {10, 20, 31}}));
    const pcl::PCLPointField* field = io::find_field(cloud, "intensity");
    ASSERT_TRUE(field);
    for (std::size_t i = 0; i < 3; ++i) {
      float intensity = 0;
      std::memcpy(&intensity, &cloud.data[i * cloud.point_step + field->offset], sizeof intensity);
      EXPECT_EQ(intensity, i == 0 ? 0.5f : 1.5f);
    }
  }
}

/// One row of two points with x, z of floats, y of doubles, and three channels of any type.
template <typename Channel>
PointCloud2 separate_colours(std::uint8_t type, Channel scale, bool big_endian) {
  PointCloud2 cloud;
  add_field(cloud, "X", 0, PointField::FLOAT32);
  add_field(cloud, "Y", 4, PointField::FLOAT64);
  add_field(cloud, "Z", 12, PointField::FLOAT32);
  const char* const names[3] = {"r", "g", "b"};
  for (std::uint32_t k = 0; k < 3; ++k)
    add_field(cloud, names[k], 17 + k * static_cast<std::uint32_t>(sizeof(Channel)), type);
  cloud.width = 2, cloud.height = 1;
  cloud.point_step = 17 + 3 * sizeof(Channel) + 5;
  cloud.row_step = 2 * cloud.point_step;
  cloud.is_bigendian = big_endian;
  cloud.data.resize(cloud.row_step, 0xcd);
  const auto store = [&](std::size_t offset, auto value) {
    auto* bytes = reinterpret_cast<std::uint8_t*>(&value);
    if (big_endian) std::reverse(bytes, bytes + sizeof value);
    std::copy(bytes, bytes + sizeof value, cloud.data.begin() + static_cast<std::ptrdiff_t>(offset));
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t point = i * cloud.point_step;
    store(point, 0.5F + static_cast<float>(i));
    store(point + 4, 0.1);
    store(point + 12, -2.0F);
    for (std::size_t k = 0; k < 3; ++k)
      store(point + 17 + k * sizeof(Channel),
            static_cast<Channel>(scale * static_cast<Channel>(i == 0 ? 1 : k)));
  }
  return cloud;
}

TEST(Conversions, ReadsSeparateColoursOfAnyTypeAndMixedCoordinates) {
  for (const bool big_endian : {false, true}) {
    const auto check = [](const PointCloud2& message, std::uint8_t one, std::uint8_t two) {
      const pcl::PCLPointCloud2 cloud = to_cloud(message);
      EXPECT_EQ(io::positions_of(cloud), (std::vector<Point>{{0.5, 0.1, -2}, {1.5, 0.1, -2}}));
      EXPECT_EQ(io::colours_of(cloud), (std::vector<io::Colour>{{one, one, one}, {0, one, two}}));
    };
    check(separate_colours<std::uint8_t>(PointField::UINT8, 100, big_endian), 100, 200);
    check(separate_colours<std::uint16_t>(PointField::UINT16, 257 * 50, big_endian), 50, 100);
    check(separate_colours<float>(PointField::FLOAT32, 0.4F, big_endian), 102, 204);
    check(separate_colours<double>(PointField::FLOAT64, 100, big_endian), 100, 200);
  }
}

TEST(Conversions, ACloudWithoutPointsNeedsNoFields) {
  EXPECT_TRUE(io::positions_of(to_cloud(PointCloud2())).empty());
}

TEST(Conversions, AnEmptyCloudIsNoError) {
  PointCloud2 empty;
  pcl_conversions::fromPCL(io::make_cloud({}), empty);
  EXPECT_TRUE(read(empty).empty());
}

TEST(Conversions, ReadsAnOnlyRowWhateverLengthItHas) {
  for (const std::uint32_t row_step : {0u, 1u, 4000000000u}) {
    PointCloud2 cloud = message();
    cloud.row_step = row_step;
    EXPECT_EQ(read(cloud).size(), 4u);
  }
}

TEST(Conversions, RefusesCloudsThatContradictThemselves) {
  const auto refused = [](const auto& spoil) {
    PointCloud2 cloud = message();
    spoil(cloud);
    EXPECT_THROW(read(cloud), std::runtime_error);
  };
  refused([](PointCloud2& cloud) { cloud.fields.clear(); });
  refused([](PointCloud2& cloud) { cloud.fields[1].name = "why"; });
  refused([](PointCloud2& cloud) { cloud.fields[0].datatype = 77; });
  refused([](PointCloud2& cloud) { cloud.fields[2].offset = 13; });
  refused([](PointCloud2& cloud) { cloud.fields[2].offset = 0xffffffff; });
  refused(
      [](PointCloud2& cloud) { cloud.fields[0].datatype = PointField::FLOAT64, cloud.fields[0].offset = 9; });
  refused([](PointCloud2& cloud) { cloud.fields[3].count = 2; });
  refused([](PointCloud2& cloud) { cloud.data.pop_back(); });
  refused([](PointCloud2& cloud) { cloud.width = 5; });
  refused([](PointCloud2& cloud) { cloud.width = 0xffffffff; });
  refused([](PointCloud2& cloud) { cloud.height = 0xffffffff; });
  refused([](PointCloud2& cloud) { cloud.height = 2, cloud.row_step = 16; });
  refused([](PointCloud2& cloud) { cloud.point_step = 0; });
}

TEST(Conversions, NothingThatIsHandedInCrashes) {
  test::Random random(11);
  const PointCloud2 good = message();
  int refused = 0;
  for (int round = 0; round < 20000; ++round) {
    PointCloud2 cloud = good;
    const auto odd = [&random] {
      const int kind = random.below(3);
      return static_cast<std::uint32_t>(kind == 0   ? random.below(40)
                                        : kind == 1 ? -random.below(40)
                                                    : random.below(8));
    };
    for (int change = random.below(3); change >= 0; --change) switch (random.below(8)) {
        case 0:
          cloud.width = odd();
          break;
        case 1:
          cloud.height = odd();
          break;
        case 2:
          cloud.point_step = odd();
          break;
        case 3:
          cloud.row_step = odd();
          break;
        case 4:
          cloud.fields[random.below(4)].offset = odd();
          break;
        case 5:
          cloud.fields[random.below(4)].datatype = static_cast<std::uint8_t>(odd());
          break;
        case 6:
          cloud.data.resize(static_cast<std::size_t>(random.below(80)));
          break;
        default:
          cloud.fields.erase(cloud.fields.begin() + random.below(3)), cloud.fields.resize(4);
          break;
      }
    cloud.is_bigendian = random.below(2) == 1;
    try {
      read(cloud);
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_LT(refused, 19000);
}

TEST(Conversions, AMarkerHasTheCornersOfAllTriangles) {
  visualization_msgs::Marker marker = to_marker(tetrahedron());
  EXPECT_EQ(marker.type, visualization_msgs::Marker::TRIANGLE_LIST);
  EXPECT_EQ(marker.action, visualization_msgs::Marker::ADD);
  EXPECT_EQ(marker.color.a, 1);
  ASSERT_EQ(marker.points.size(), 12u);
  ASSERT_EQ(marker.colors.size(), 12u);
  EXPECT_EQ(marker.points[5].z, 1);
  const float shade = marker.colors[5].g * 255 / 2;
  EXPECT_GE(shade, 0.5f);
  EXPECT_LE(shade, 1);
  EXPECT_FLOAT_EQ(marker.colors[5].r, shade * 1 / 255);
  EXPECT_FLOAT_EQ(marker.colors[5].b, shade * 3 / 255);
  EXPECT_EQ(marker.colors[5].a, 1);

  pcl::PolygonMesh empty;
  empty.cloud = io::make_cloud({});
  marker = to_marker(empty);
  EXPECT_EQ(marker.action, visualization_msgs::Marker::DELETE);
  EXPECT_TRUE(marker.points.empty());
  EXPECT_TRUE(marker.colors.empty());
}

TEST(Conversions, ATransformIsAPose) {
  geometry_msgs::Transform transform;
  transform.rotation.z = transform.rotation.w = std::sqrt(0.5);  // a quarter turn about z
  transform.translation.x = 5;
  const Eigen::Vector3d moved = to_pose(transform) * Eigen::Vector3d(1, 0, 2);
  EXPECT_LT((moved - Eigen::Vector3d(5, 1, 2)).norm(), 1e-12);
}

}  // namespace
}  // namespace filmsticking::stream
