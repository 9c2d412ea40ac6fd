// SPDX-License-Identifier: GPL-3.0-or-later
// Formats by their names.
#include <gtest/gtest.h>

#include <algorithm>

#include "samples.h"

namespace filmsticking::test {
namespace {

TEST(Formats, MessagesListAllThatCanBeReadOrWritten) {
  const ScratchFolder folder;
  write_text(folder / "cloud.foo", "prose without numbers");
  const auto message = [](const auto& work) -> std::string {
    try {
      work();
    } catch (const IoError& error) {
      return error.what();
    }
    return "";
  };
  const std::string path = folder / "cloud.foo";
  const std::string none =
      "its content is of no format that is read: pcd ply obj stl vtk off las ptx pts xyz "
      "txt csv asc grid";
  EXPECT_EQ(message([&] { io::read_cloud(path); }), none);
  EXPECT_EQ(message([&] { io::read_mesh(path); }), none);
  EXPECT_EQ(message([&] { io::read_model(path); }), none);
  EXPECT_EQ(message([&] { io::write_mesh(path, tetrahedron(true)); }),
            "its extension is none of " + io::extensions_of(io::mesh_formats()));
  EXPECT_EQ(io::extensions_of(io::mesh_formats()), ".ply .obj .stl .vtk .glb");
}

TEST(Formats, AMeshIsSentInPiecesOfItsSize) {
  Model model;
  for (int i = 0; i < 20000; ++i) {
    model.positions.push_back({i / 3.0, 0.1 * (i % 7), -i / 7.0});
    model.colours.push_back({static_cast<std::uint8_t>(i), 1, 2});
    model.triangles.push_back({i, (i + 1) % 20000, (i + 2) % 20000});
  }
  const pcl::PolygonMesh mesh = model;
  for (const std::string& format : io::mesh_formats()) {
    if (format == "vtk") continue;  // VTK's writer makes it whole
    std::size_t most = 0;
    std::string sent;
    io::encode_mesh(format, mesh.cloud, model.triangles, [&](std::string_view piece) {
      most = std::max(most, piece.size());
      sent += piece;
    });
    EXPECT_GT(sent.size(), 400000u) << format;
    EXPECT_LT(most, 70000u) << format;
    EXPECT_EQ(sent, io::encode_mesh(format, model)) << format;
  }
}

TEST(Formats, ColumnsOfTextsAloneLeaveOtherFilesAsTheyAre) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
      "end_header\n7 8 9\n";
  const std::vector<std::string> columns = {"_", "z", "y", "x"};
  EXPECT_THROW(io::decode_any(ply, ".ply", {0, {}, columns}), IoError);
  const io::Cloud other = io::decode_any(ply, ".ply", {0, {}, columns, true});
  EXPECT_EQ(io::positions_of(other.points), (std::vector<Point>{{7, 8, 9}}));
  EXPECT_EQ(other.notes.size(), 1u);
  EXPECT_EQ(io::positions_of(io::decode_any("1 2 3 4\n", ".xyz", {0, {}, columns, true}).points),
            (std::vector<Point>{{4, 3, 2}}));
}

}  // namespace
}  // namespace filmsticking::test
