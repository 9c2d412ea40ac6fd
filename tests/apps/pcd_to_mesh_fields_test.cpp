// SPDX-License-Identifier: GPL-3.0-or-later
// What goes with the points into meshes and clouds: colours, normals, every field.
#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/formats.h"
#include "support/pcd_to_mesh.h"

namespace filmsticking::test {
namespace {

/// The normals of all points; empty where the file has none.
std::vector<Point> normals_in(const pcl::PCLPointCloud2& cloud) {
  std::vector<Point> normals;
  const pcl::PCLPointField* x = io::find_field(cloud, "normal_x");
  for (std::size_t i = 0; x != nullptr && i < io::size_of(cloud); ++i) {
    float n[3];
    std::memcpy(n, io::bytes_of(cloud, i) + x->offset, sizeof n);
    normals.push_back({n[0], n[1], n[2]});
  }
  return normals;
}

TEST(PcdToMesh, ColoursGoWithTheirPoints) {
  const ScratchFolder folder;
  Model cloud = io::read_cloud(kBunny);
  std::map<Point, io::Colour> colour_of;
  for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
    cloud.colours.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 2), 77});
    colour_of[cloud.positions[i]] = cloud.colours.back();
  }
  io::write_mesh(folder / "cloud.ply", cloud);
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / "mesh.ply"}).status, 0);
  const Model mesh = io::read_mesh(folder / "mesh.ply");
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  for (std::size_t k = 0; k < mesh.positions.size(); ++k)
    EXPECT_EQ(mesh.colours[k], colour_of.at(mesh.positions[k]));
}

TEST(PcdToMesh, ColoursGoIntoEveryFormatThatHasThem) {
  const ScratchFolder folder;
  Model cloud = io::read_cloud(kBunny);
  std::map<Point, io::Colour> colour_of;
  for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
    cloud.colours.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 2), 77});
    colour_of[cloud.positions[i]] = cloud.colours.back();
  }
  io::write_mesh(folder / "cloud.ply", cloud);
  for (const char* name : {"mesh.obj", "mesh.vtk"}) {
    ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / name}).status, 0);
    const Model mesh = io::read_mesh(folder / name);
    ASSERT_EQ(mesh.colours.size(), mesh.positions.size()) << name;
    for (std::size_t k = 0; k < mesh.positions.size(); ++k)
      EXPECT_EQ(mesh.colours[k], colour_of.at(mesh.positions[k])) << name;
  }
}

TEST(PcdToMesh, StabilityIsAColourAndInTheReport) {
  const ScratchFolder folder;
  const Outcome outcome =
      pcd_to_mesh({kSpot, folder / "spot.ply", "--stability", "--report", folder / "spot.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Model mesh = io::read_mesh(folder / "spot.ply");
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  std::size_t white = 0;
  for (const auto& colour : mesh.colours) {
    EXPECT_EQ(colour[0], 255);
    EXPECT_EQ(colour[1], colour[2]);
    white += colour[1] == 255 ? 1 : 0;
  }
  EXPECT_GT(2 * white, mesh.colours.size());
  EXPECT_LT(white, mesh.colours.size());
  EXPECT_GT(read_json(folder / "spot.json").at("stability").get<double>(), 0.8);
}

TEST(PcdToMesh, NormalsOfAllPointsAndOfTheVerticesAreWritten) {
  const ScratchFolder folder;
  Model ball;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 2000; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random), r = std::hypot(x, y, z);
    ball.positions.push_back({x / r, y / r, z / r});
  }
  ball.positions.push_back({0, 0, 9});  // an outlier
  io::write_mesh(folder / "ball.ply", ball);
  for (const std::string kind : {"ply", "pcd"}) {
    const std::string points = folder / ("points." + kind);
    const Outcome outcome =
        pcd_to_mesh({folder / "ball.ply", folder / "mesh.ply", "--normals", "--points-out", points});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const io::Cloud cloud = io::read_cloud(points);
    EXPECT_EQ(io::positions_of(cloud.points), ball.positions);
    const std::vector<Point> normals = normals_in(cloud.points);
    ASSERT_EQ(normals.size(), ball.positions.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const Point& p = ball.positions[i];
      const Point& n = normals[i];
      EXPECT_GT(p[0] * n[0] + p[1] * n[1] + p[2] * n[2], 0.9);
    }
  }
  EXPECT_EQ(normals_in(io::read_mesh(folder / "mesh.ply").cloud).size(), 2000U);
  ASSERT_EQ(pcd_to_mesh({folder / "ball.ply", folder / "mesh.ply", "--points-out", folder / "p.xyz"}).status,
            0);
  std::ifstream text(folder / "p.xyz");
  double x[6];
  for (const Point& p : ball.positions) {
    for (double& number : x) text >> number;
    EXPECT_EQ((Point{x[0], x[1], x[2]}), p);
    EXPECT_GT(p[0] * x[3] + p[1] * x[4] + p[2] * x[5], 0.9);
  }
  EXPECT_TRUE(normals_in(io::read_mesh(folder / "mesh.ply").cloud).empty());  // not asked for
}

TEST(PcdToMesh, NormalsThatCannotBeWrittenAreRefusedBeforeTheWork) {
  const ScratchFolder folder;
  expect_failure({kBunny, folder / "m.obj", "--normals"}, folder, 1);
  expect_failure({kBunny, folder / "m.ply", "--points-out", folder / "p.obj"}, folder, 1);
  expect_failure({kBunny, folder / "m.ply", "--points-out", folder / "m.ply"}, folder, 1);
  EXPECT_EQ(pcd_to_mesh({kBunny, kSpot, folder / "", "--points-out", folder / "p.ply"}).status, 2);
}

/// The bunny with a normal, an intensity, a label and a field that nobody has heard of at every point.
pcl::PCLPointCloud2 bunny_with_fields() {
  using Type = pcl::PCLPointField;
  const std::vector<Point> positions = io::positions_of(io::read_cloud(kBunny).points);
  std::vector<pcl::PCLPointField> fields;
  std::size_t step = 0;
  const auto add = [&](const char* name, std::uint8_t type) {
    fields.push_back(io::make_field(name, step, type));
    step += io::size_of(io::Scalar{type});
  };
  for (const char* name : {"x", "y", "z", "normal_x", "normal_y", "normal_z", "intensity"})
    add(name, Type::FLOAT32);
  add("label", Type::UINT32);
  add("gps_seconds", Type::FLOAT64);
  add("ring", Type::UINT16);
  pcl::PCLPointCloud2 cloud = io::make_rows(fields, step, positions.size());
  const io::PositionFields places(cloud);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    std::uint8_t* point = &cloud.data[i * step];
    places.store(positions[i], point);
    const auto number = static_cast<float>(i);
    const float values[4] = {0.1F * number, -0.2F, 1 / (number + 1), 0.3F * number};
    const std::uint32_t label = 4000000000U + static_cast<std::uint32_t>(i);
    const double seconds = 1.6e9 + 1e-6 * static_cast<double>(i);
    const auto ring = static_cast<std::uint16_t>(60000 + i);
    std::memcpy(point + 12, values, sizeof values);
    std::memcpy(point + 28, &label, sizeof label);
    std::memcpy(point + 32, &seconds, sizeof seconds);
    std::memcpy(point + 40, &ring, sizeof ring);
  }
  return cloud;
}

/// Every vertex of the mesh has the fields of the input's point at its place, in type and value.
void expect_fields_kept(const pcl::PCLPointCloud2& mesh, const pcl::PCLPointCloud2& cloud) {
  std::map<Point, std::size_t> point_at;
  const std::vector<Point> points = io::positions_of(cloud), vertices = io::positions_of(mesh);
  for (std::size_t i = 0; i < points.size(); ++i) point_at[points[i]] = i;
  EXPECT_GT(vertices.size(), 300u);
  for (const pcl::PCLPointField& field : cloud.fields) {
    const pcl::PCLPointField* kept = io::find_field(mesh, field.name.c_str());
    ASSERT_NE(kept, nullptr) << field.name;
    ASSERT_EQ(kept->datatype, field.datatype) << field.name;
    for (std::size_t k = 0; k < vertices.size(); ++k)
      ASSERT_EQ(std::memcmp(io::bytes_of(mesh, k) + kept->offset,
                            io::bytes_of(cloud, point_at.at(vertices[k])) + field.offset,
                            io::size_of(io::Scalar{field.datatype})),
                0)
          << field.name << " of vertex " << k;
  }
}

TEST(PcdToMesh, EveryFieldGoesWithItsPointFromPcdAndPlyToPly) {
  const ScratchFolder folder;
  const pcl::PCLPointCloud2 cloud = bunny_with_fields();
  pcl::PCDWriter().writeBinary(folder / "cloud.pcd", cloud);
  io::write_mesh(folder / "cloud.ply", cloud, {});
  for (const char* name : {"cloud.pcd", "cloud.ply"}) {
    SCOPED_TRACE(name);
    const Outcome outcome = pcd_to_mesh({folder / name, folder / "mesh.ply"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    expect_fields_kept(io::read_mesh(folder / "mesh.ply").cloud, cloud);
    // The names that PLY's readers know.
    const std::string bytes = io::read_file(folder / "mesh.ply");
    for (const char* property :
         {"float nx", "float intensity", "uint label", "double gps_seconds", "ushort ring"})
      EXPECT_NE(bytes.find(std::string("property ") + property + "\n"), std::string::npos) << property;
  }
}

TEST(PcdToMesh, EveryFieldIsKeptBesideDoubleCoordinatesAndBehindFilters) {
  const ScratchFolder folder;
  const pcl::PCLPointCloud2 cloud = bunny_with_fields();
  std::vector<Point> far = io::positions_of(cloud);
  for (Point& p : far) p = {p[0] + 500000.1, p[1] + 4649776.7, p[2] + 123.4};
  const pcl::PCLPointCloud2 moved = io::with_positions(cloud, far);
  pcl::PCDWriter().writeBinary(folder / "cloud.pcd", moved);
  const Outcome outcome = pcd_to_mesh({folder / "cloud.pcd", folder / "mesh.ply", "--sor", "16,3"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  expect_fields_kept(io::read_mesh(folder / "mesh.ply").cloud, moved);
}

}  // namespace
}  // namespace filmsticking::test
