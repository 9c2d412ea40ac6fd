// SPDX-License-Identifier: GPL-3.0-or-later
// pcd_to_mesh on files of many kinds: what it says of them, several as one, and the precision of its meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/files.h"
#include "io/formats.h"
#include "support/pcd_to_mesh.h"

namespace filmsticking::test {
namespace {

/// A point of a sphere, spread evenly.
Point on_sphere(int i, int count) {
  const double z = 1 - (2 * i + 1.0) / count, radius = std::sqrt(1 - z * z), angle = 2.399963229728653 * i;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

constexpr int kPoints = 400;

/// Lines "x y z" with `digits` behind the point, for the points from `begin` on.
std::string lines(int begin, int end, const Point& origin, int digits, const std::string& ahead = "",
                  const std::string& behind = "") {
  std::string text;
  for (int i = begin; i < end; ++i) {
    const Point p = on_sphere(i, kPoints);
    char line[200];
    std::snprintf(line, sizeof line, "%s%.*f %.*f %.*f%s\n", ahead.c_str(), digits, origin[0] + p[0], digits,
                  origin[1] + p[1], digits, origin[2] + p[2], behind.c_str());
    text += line;
  }
  return text;
}

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

bool is_double(const std::string& mesh) {
  return io::read_file(mesh).find("property double x") != std::string::npos;
}

TEST(PcdToMeshFormats, TheColumnsThatWereGuessedAreSaid) {
  const ScratchFolder folder;
  write(folder / "cloud.txt", lines(0, kPoints, {}, 6, "P ", " 10 20 30"));
  const Outcome outcome =
      pcd_to_mesh({folder / "cloud.txt", folder / "mesh.ply", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("columns 2 to 4 as x y z, columns 5 to 7 as r g b"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("--columns"), std::string::npos);
  const auto report = nlohmann::json::parse(io::read_file(folder / "r.json"));
  EXPECT_EQ(report.at("notes").size(), 1u);
  const Model mesh = io::read_mesh(folder / "mesh.ply");
  EXPECT_EQ(mesh.positions.size(), static_cast<std::size_t>(kPoints));
  EXPECT_EQ(mesh.colours[0], (io::Colour{10, 20, 30}));
}

TEST(PcdToMeshFormats, ColumnsAreTakenAsTheUserNamesThem) {
  const ScratchFolder folder;
  write(folder / "cloud.txt", lines(0, kPoints, {}, 6, "7 ", " 10 20 30"));
  const Outcome outcome =
      pcd_to_mesh({folder / "cloud.txt", folder / "mesh.ply", "--columns", "label,x,y,z,b,_,r"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const pcl::PCLPointCloud2 vertices = io::read_mesh(folder / "mesh.ply").cloud;
  EXPECT_TRUE(io::find_field(vertices, "label"));
  EXPECT_TRUE(io::find_field(vertices, "r"));
}

TEST(PcdToMeshFormats, CoordinatesAreDoubleOnlyWhereTheyMustOrOnRequest) {
  const ScratchFolder folder;
  write(folder / "near.xyz", lines(0, kPoints, {}, 6));
  write(folder / "utm.xyz", lines(0, kPoints, {483020, 5457020, 250}, 3));
  const std::string mesh = folder / "mesh.ply";
  ASSERT_EQ(pcd_to_mesh({folder / "near.xyz", mesh}).status, 0);
  EXPECT_FALSE(is_double(mesh));
  ASSERT_EQ(pcd_to_mesh({folder / "near.xyz", mesh, "--double"}).status, 0);
  EXPECT_TRUE(is_double(mesh));
  ASSERT_EQ(pcd_to_mesh({folder / "utm.xyz", mesh}).status, 0);
  EXPECT_TRUE(is_double(mesh));
  const std::vector<Point> cloud = io::positions_of(io::read_cloud(folder / "utm.xyz").points);
  for (const Point& p : Model(io::read_mesh(mesh)).positions)
    EXPECT_NE(std::find(cloud.begin(), cloud.end(), p), cloud.end());  // millimetres are exact
}

TEST(PcdToMeshFormats, FilesOfSeveralFormatsMakeOneCloud) {
  const ScratchFolder folder;
  write(folder / "a.xyz", lines(0, 150, {}, 6));
  write(folder / "b.off", "OFF\n100 0 0\n" + lines(150, 250, {}, 6));
  write(folder / "c.pcd",
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 150\nHEIGHT 1\nDATA ascii\n" +
            lines(250, kPoints, {}, 6));
  const Outcome outcome =
      pcd_to_mesh({folder / "a.xyz", folder / "b.off", folder / "c.pcd", folder / "mesh.ply", "--merge"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("and 2 more: 400 points"), std::string::npos) << outcome.out;
  EXPECT_EQ(Model(io::read_mesh(folder / "mesh.ply")).positions.size(), static_cast<std::size_t>(kPoints));
  // The output must not be one of the inputs.
  EXPECT_NE(pcd_to_mesh({folder / "a.xyz", folder / "mesh.ply", folder / "mesh.ply", "--merge"}).status, 0);
}

TEST(PcdToMeshFormats, ValuesForNoReturnSpoilNothing) {
  const ScratchFolder folder;
  for (const char* far : {"3.4028235e38 3.4028235e38 3.4028235e38\n", "1e10 1e10 1e10\n", "0 1e10 0\n"})
    for (const bool filtered : {false, true}) {
      write(folder / "cloud.xyz", far + lines(0, kPoints, {}, 6) + far);
      std::vector<std::string> arguments = {folder / "cloud.xyz", folder / "mesh.ply"};
      if (filtered) arguments.insert(arguments.end(), {"--voxel", "0.01"});
      const Outcome outcome = pcd_to_mesh(arguments);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_EQ(Model(io::read_mesh(folder / "mesh.ply")).positions.size(), static_cast<std::size_t>(kPoints))
          << far;
      EXPECT_FALSE(is_double(folder / "mesh.ply"));
    }
}

TEST(PcdToMeshFormats, MissingHeightsAreLeftOffAndCounted) {
  const ScratchFolder folder;
  std::string text;
  for (int i = 0; i < 900; ++i)
    text += std::to_string(i % 30) + " " + std::to_string(i / 30) + " " +
            (i % 97 == 5 ? "-9999" : std::to_string(5 + std::sin(0.3 * (i % 30)))) + "\n";
  write(folder / "heights.xyz", text);
  const Outcome outcome = pcd_to_mesh({folder / "heights.xyz", folder / "mesh.ply", "--open"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("10 points without a height"), std::string::npos) << outcome.err;
  for (const Point& p : Model(io::read_mesh(folder / "mesh.ply")).positions) EXPECT_GT(p[2], 0);
}

TEST(PcdToMeshFormats, TheContentDecidesNotTheExtension) {
  const ScratchFolder folder;
  write(folder / "cloud.las", lines(0, kPoints, {}, 6));
  EXPECT_EQ(pcd_to_mesh({folder / "cloud.las", folder / "mesh.ply"}).status, 0);
  write(folder / "cloud.laz", "LASF" + std::string(100, '\x80'));
  const Outcome outcome = pcd_to_mesh({folder / "cloud.laz", folder / "mesh.ply"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("cloud.laz: "), std::string::npos) << outcome.err;
}

TEST(PcdToMeshFormats, FormatListsWhatThereIs) {
  const Outcome outcome = pcd_to_mesh({"a", "b", "--format", "?"});
  EXPECT_EQ(outcome.status, 2);
  for (const std::string& format : io::cloud_formats())
    EXPECT_NE(outcome.err.find(" " + format), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace filmsticking::test
