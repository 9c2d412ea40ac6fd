// SPDX-License-Identifier: GPL-3.0-or-later
// Many inputs, standard input and output.
#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "io/formats.h"
#include "support/pcd_to_mesh.h"

namespace filmsticking::test {
namespace {

namespace fs = std::filesystem;

TEST(PcdToMesh, ABatchIsTheMeshesOneByOne) {
  const ScratchFolder folder;
  std::ofstream(folder / "flat.xyz") << "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 1 0\n";
  const std::string lamppost = TEST_DATA "/lamppost.pcd";
  const Outcome outcome =
      pcd_to_mesh({folder / "flat.xyz", kBunny, folder / "missing.pcd", lamppost, folder / "new/meshes/",
                   "--jobs", "2", "--to", "obj", "--report", folder / "report.json"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 2) << outcome.err;
  EXPECT_NE(outcome.err.find("flat.xyz: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("missing.pcd: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("2 of 4 meshes"), std::string::npos) << outcome.out;
  for (const auto& [name, cloud] : {std::pair{"bun0.obj", kBunny}, {"lamppost.obj", lamppost}}) {
    ASSERT_EQ(pcd_to_mesh({cloud, folder / "alone.obj"}).status, 0);
    EXPECT_TRUE(io::read_file((folder / "new/meshes/") + name) == io::read_file(folder / "alone.obj"))
        << name;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "new/meshes"), fs::directory_iterator()), 2);
  const Json report = read_json(folder / "report.json");
  ASSERT_EQ(report.size(), 3u);  // the missing one was not tried
  EXPECT_EQ(report.front().at("status").get<std::string>(), "Coplanar");
}

TEST(PcdToMesh, AFolderThatIsThereTakesMeshes) {
  const ScratchFolder folder;
  EXPECT_EQ(pcd_to_mesh({kBunny, folder.path().string()}).status, 0);
  EXPECT_EQ(pcd_to_mesh({"--out-dir", folder.path().string(), TEST_DATA "/bun4.pcd"}).status, 0);
  EXPECT_TRUE(fs::exists(folder / "bun0.ply"));
  EXPECT_TRUE(fs::exists(folder / "bun4.ply"));
  EXPECT_EQ(pcd_to_mesh({kBunny, folder / "bun0.ply/"}).status, 1);  // a file is in the way
}

TEST(PcdToMesh, StandardInputAndOutput) {
  const ScratchFolder folder;
  const Model cloud = io::read_cloud(kBunny);
  io::write_mesh(folder / "cloud.ply", cloud);
  pcl::PCDWriter().writeBinary(folder / "cloud.pcd", io::make_cloud(cloud.positions));
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / "expected.ply"}).status, 0);
  const std::string expected = io::read_file(folder / "expected.ply");
  io::write_mesh(folder / "cloud.obj", cloud);
  std::ofstream text(folder / "cloud.xyz");
  text.precision(17);
  for (const Point& p : cloud.positions) text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  text.close();
  const auto through_shell = [&](const std::string& file, const std::string& options) {
    return run_program({"/bin/sh", "-c", PCD_TO_MESH " - - " + options + " < " + file});
  };
  for (const char* name : {"cloud.pcd", "cloud.ply", "cloud.obj", "cloud.xyz"}) {
    const std::string file = folder / name;
    const Outcome outcome = through_shell(file, "");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(outcome.out == expected) << file;
    EXPECT_NE(outcome.err.find("closed  yes"), std::string::npos) << outcome.err;
  }
  EXPECT_TRUE(through_shell(folder / "cloud.xyz", "--format txt").out == expected);
  const Outcome obj = through_shell(kBunny, "--to obj");
  io::write_file(folder / "piped.obj", obj.out);
  EXPECT_EQ(Model(io::read_mesh(folder / "piped.obj")).triangles,
            Model(io::read_mesh(folder / "expected.ply")).triangles);

  std::ofstream(folder / "noise") << "what is this";
  for (const std::string& file : {std::string("/dev/null"), folder / "noise"}) {
    const Outcome outcome = through_shell(file, "");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(run_program({"/bin/sh", "-c", PCD_TO_MESH " " + kBunny + " - > /dev/full"}).status, 1);
}

TEST(PcdToMesh, AFilePastTheSizeLimitIsSaidAndNothingIsLeft) {
  const ScratchFolder folder;
  const Outcome outcome = run_program(
      {"/bin/sh", "-c", "ulimit -f 1; exec " PCD_TO_MESH " " + kBunny + " " + (folder / "mesh.ply")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("it cannot be written"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.count(), 0u);
}

}  // namespace
}  // namespace filmsticking::test
