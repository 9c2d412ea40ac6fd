// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes in every format: the same bits, and what other readers see.
#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "io/formats.h"
#include "support/pcd_to_mesh.h"

namespace filmsticking::test {
namespace {

TEST(PcdToMesh, ReadsEveryFormatToTheSameMesh) {
  const ScratchFolder folder;
  const Model cloud = io::read_cloud(kBunny);
  io::write_mesh(folder / "cloud.ply", Model(cloud.positions, {}, {}));
  io::write_mesh(folder / "cloud.obj", Model(cloud.positions, {}, {}));
  for (const char* name : {"cloud.xyz", "cloud.TXT"}) {
    std::ofstream text(folder / name);
    text.precision(17);
    for (const Point& p : cloud.positions) text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  pcl::PCDWriter().writeBinary(folder / "cloud.pcd", io::make_cloud(cloud.positions));
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.pcd", folder / "expected.ply"}).status, 0);
  const std::string expected = io::read_file(folder / "expected.ply");
  for (const char* name : {"cloud.ply", "cloud.obj", "cloud.xyz", "cloud.TXT"}) {
    const Outcome outcome = pcd_to_mesh({folder / name, folder / "mesh.ply"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(io::read_file(folder / "mesh.ply") == expected) << name;
  }
}

TEST(PcdToMesh, WritesEveryFormatWithTheSameBits) {
  const ScratchFolder folder;
  ASSERT_EQ(pcd_to_mesh({kBunny, folder / "mesh.ply"}).status, 0);
  const Model expected = io::read_mesh(folder / "mesh.ply");
  for (const char* name : {"mesh.obj", "mesh.vtk", "mesh.stl"}) {
    const Outcome outcome = pcd_to_mesh({kBunny, folder / name});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Model mesh = io::read_mesh(folder / name);
    const auto corner_points = [](const Model& model) {  // STL keeps no numbers of vertices
      std::vector<Point> points;
      for (const Triangle& t : model.triangles)
        for (const int k : t) points.push_back(model.positions[k]);
      return points;
    };
    EXPECT_EQ(corner_points(mesh), corner_points(expected)) << name;
    EXPECT_EQ(mesh.positions.size(), expected.positions.size());
  }
}

TEST(PcdToMesh, LargeDoubleCoordinatesAreKept) {
  const ScratchFolder folder;
  Model cloud = io::read_cloud(kBunny);
  for (Point& p : cloud.positions) p = {p[0] * 10 + 500000.1, p[1] * 10 + 4649776.7, p[2] * 10 + 123.4};
  io::write_mesh(folder / "cloud.ply", cloud);
  for (const char* name : {"mesh.ply", "mesh.obj", "mesh.vtk"}) {
    const Outcome outcome = pcd_to_mesh({folder / "cloud.ply", folder / name});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    expect_surface_through(io::read_mesh(folder / name), cloud);
  }
}

TEST(PcdToMesh, ColoursAreInGltfAsAnotherReaderSeesIt) {
  const ScratchFolder folder;
  Model cloud = io::read_cloud(kSpot);
  cloud.positions.resize(3000);
  for (std::size_t i = 0; i < cloud.positions.size(); ++i)
    cloud.colours.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 20), 77});
  io::write_mesh(folder / "cloud.ply", cloud);
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / "mesh.ply"}).status, 0);
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / "mesh.glb"}).status, 0);
  const Model expected = io::read_mesh(folder / "mesh.ply");

  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName((folder / "mesh.glb").c_str());
  reader->Update();
  const auto blocks = vtkSmartPointer<vtkDataObjectTreeIterator>::New();
  blocks->SetDataSet(reader->GetOutput());
  blocks->VisitOnlyLeavesOn();
  blocks->InitTraversal();
  ASSERT_FALSE(blocks->IsDoneWithTraversal());
  auto* const mesh = vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject());
  ASSERT_NE(mesh, nullptr);
  ASSERT_EQ(mesh->GetNumberOfPoints(), static_cast<vtkIdType>(expected.positions.size()));
  ASSERT_EQ(mesh->GetNumberOfCells(), static_cast<vtkIdType>(expected.triangles.size()));
  for (std::size_t t = 0; t < expected.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(mesh->GetCell(static_cast<vtkIdType>(t))->GetPointId(k), expected.triangles[t][k]);
  vtkDataArray* const colours = mesh->GetPointData()->GetArray("COLOR_0");
  ASSERT_NE(colours, nullptr);
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(mesh->GetPoint(k)[axis], expected.positions[k][axis]);
      const double light = colours->GetComponent(k, axis);  // back to sRGB, as the eye has it
      const double share = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
      ASSERT_EQ(std::lround(255 * share), expected.colours[k][axis]);
    }
  }
}

TEST(PcdToMesh, GltfOfLargeCoordinatesKeepsTheShape) {
  const ScratchFolder folder;
  Model cloud = io::read_cloud(kBunny);
  for (Point& p : cloud.positions) p = {p[0] + 500000.1, p[1] + 4649776.7, p[2] + 123.4};
  io::write_mesh(folder / "cloud.ply", cloud);
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / "mesh.ply"}).status, 0);
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / "mesh.glb"}).status, 0);
  const Model expected = io::read_mesh(folder / "mesh.ply");

  // A binary glTF is a header of 12 bytes, then JSON and the buffer, each after its length and kind.
  const std::string bytes = io::read_file(folder / "mesh.glb");
  std::uint32_t json_size = 0;
  std::memcpy(&json_size, bytes.data() + 12, sizeof json_size);
  const Json json = Json::parse(bytes.substr(20, json_size));
  Point moved{};
  int axis = 0;
  for (const Json& value : json.at("nodes").front().at("translation")) moved[axis++] = value.get<double>();
  const char* buffer = bytes.data() + 20 + json_size + 8;
  for (const Point& p : expected.positions)
    for (axis = 0; axis < 3; ++axis) {
      float x = 0;
      std::memcpy(&x, buffer, sizeof x);
      buffer += sizeof x;
      ASSERT_NEAR(moved[axis] + x, p[axis], 1e-8);
    }
}

}  // namespace
}  // namespace filmsticking::test
