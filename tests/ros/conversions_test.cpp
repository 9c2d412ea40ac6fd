// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversions.h"

#include <geometry_msgs/Transform.h>
#include <gtest/gtest.h>
#include <pcl_msgs/PolygonMesh.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/Marker.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "support/clouds.h"

namespace filmsticking::stream {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

io::Model tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {1, 2, 3}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
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
      store(point + 24, row == 1 && column == 0 ? std::nan("") : 0.1 + static_cast<double>(column));
      store(point + 16, 0.2 + static_cast<double>(row));
      store(point + 8, -3.0);
      store(point + 32, std::uint32_t{0xff0a141e} + static_cast<std::uint32_t>(column));
    }
  return cloud;
}

TEST(Conversions, ReadsAnyLayout) {
  for (const bool big_endian : {false, true}) {
    const io::Model model = to_model(padded(big_endian));
    EXPECT_EQ(model.positions, (std::vector<Point>{{0.1, 0.2, -3}, {1.1, 0.2, -3}, {1.1, 1.2, -3}}));
    EXPECT_EQ(model.colours, (std::vector<io::Colour>{{10, 20, 30}, {10, 20, 31}, {10, 20, 31}}));
  }
}

TEST(Conversions, ACloudComesBackAsItWas) {
  io::Model model = tetrahedron();
  model.triangles.clear();
  PointCloud2 cloud;
  to_cloud(model, cloud);
  EXPECT_EQ(cloud.data.size(), 64u);
  const io::Model again = to_model(cloud);
  EXPECT_EQ(again.positions, model.positions);
  EXPECT_EQ(again.colours, model.colours);

  model.colours.clear();
  to_cloud(model, cloud);
  EXPECT_EQ(cloud.fields.size(), 3u);
  EXPECT_TRUE(to_model(cloud).colours.empty());
}

TEST(Conversions, AnEmptyCloudIsNoError) {
  PointCloud2 cloud;
  to_cloud(io::Model(), cloud);
  EXPECT_TRUE(to_model(cloud).positions.empty());
}

TEST(Conversions, ReadsAnOnlyRowWhateverLengthItTells) {
  PointCloud2 cloud;
  to_cloud(tetrahedron(), cloud);
  for (const std::uint32_t row_step : {0u, 1u, 4000000000u}) {
    cloud.row_step = row_step;
    EXPECT_EQ(to_model(cloud).positions.size(), 4u);
  }
}

TEST(Conversions, RefusesCloudsThatContradictThemselves) {
  PointCloud2 good;
  to_cloud(tetrahedron(), good);
  const auto refused = [&good](const auto& spoil) {
    PointCloud2 cloud = good;
    spoil(cloud);
    EXPECT_THROW(to_model(cloud), MessageError);
  };
  refused([](PointCloud2& cloud) { cloud.fields.clear(); });
  refused([](PointCloud2& cloud) { cloud.fields[1].name = "why"; });
  refused([](PointCloud2& cloud) { cloud.fields[0].datatype = PointField::INT16; });
  refused([](PointCloud2& cloud) { cloud.fields[2].offset = 13; });
  refused([](PointCloud2& cloud) { cloud.fields[2].offset = 0xffffffff; });
  refused(
      [](PointCloud2& cloud) { cloud.fields[0].datatype = PointField::FLOAT64, cloud.fields[0].offset = 9; });
  refused([](PointCloud2& cloud) { cloud.data.pop_back(); });
  refused([](PointCloud2& cloud) { cloud.width = 5; });
  refused([](PointCloud2& cloud) { cloud.width = 0xffffffff; });
  refused([](PointCloud2& cloud) { cloud.height = 0xffffffff; });
  refused([](PointCloud2& cloud) { cloud.height = 2, cloud.row_step = 16; });
  refused([](PointCloud2& cloud) { cloud.point_step = 0; });
}

TEST(Conversions, NothingThatIsHandedInCrashes) {
  test::Random random(11);
  PointCloud2 good;
  to_cloud(tetrahedron(), good);
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
    try {
      to_model(cloud);
    } catch (const MessageError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_LT(refused, 19000);
}

TEST(Conversions, AMeshComesBackAsItWas) {
  pcl_msgs::PolygonMesh message;
  to_polygon_mesh(tetrahedron(), message);
  const io::Model model = to_mesh_model(message);
  EXPECT_EQ(model.positions, tetrahedron().positions);
  EXPECT_EQ(model.colours, tetrahedron().colours);
  EXPECT_EQ(model.triangles, tetrahedron().triangles);

  message.polygons[0].vertices[1] = 4;
  EXPECT_THROW(to_mesh_model(message), MessageError);
}

TEST(Conversions, AMarkerHasTheCornersOfAllTriangles) {
  const io::Model model = tetrahedron();
  visualization_msgs::Marker marker;
  to_marker(model, marker);
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

  to_marker(io::Model(), marker);
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
