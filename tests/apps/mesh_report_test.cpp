// SPDX-License-Identifier: GPL-3.0-or-later
// mesh_report as a user runs it, on shapes whose figures follow from formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "io/formats.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace filmsticking::test {
namespace {

using Json = nlohmann::json;

std::set<std::string> names(const Json& json) {
  std::set<std::string> result;
  for (const auto& [name, value] : json.items()) result.insert(name);
  return result;
}

Outcome mesh_report(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), MESH_REPORT);
  return run_program(arguments);
}

const std::set<std::string> kMeshMembers{"vertices",
                                         "faces",
                                         "boundary_edges",
                                         "non_manifold_edges",
                                         "non_manifold_vertices",
                                         "self_intersections",
                                         "components",
                                         "genus",
                                         "closed",
                                         "manifold",
                                         "oriented",
                                         "outward",
                                         "area",
                                         "volume",
                                         "holes",
                                         "component_list"};

TEST(MeshReportProgram, WritesJson) {
  const ScratchFolder folder;
  for (const char* format : {".ply", ".obj", ".stl", ".vtk"}) {
    const std::string mesh = folder / (std::string("box") + format);
    io::write_mesh(mesh, box());
    const Outcome outcome = mesh_report({mesh, "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(names(json), kMeshMembers);
    EXPECT_EQ(json.at("vertices").get<int>(), 8);
    EXPECT_EQ(json.at("genus").get<int>(), 0);
    EXPECT_TRUE(json.at("closed").get<bool>());
    EXPECT_EQ(json.at("volume").get<double>(), 1);
  }
  const Json json = Json::parse(mesh_report({folder / "box.ply", "--json", "--points", folder / "box.obj",
                                             "--truth", folder / "box.stl", "--samples", "1000"})
                                    .out);
  std::set<std::string> members = kMeshMembers;
  members.insert({"points", "interpolated", "cloud_distance_mean", "cloud_distance_max", "chamfer_e3",
                  "f_score", "normal_consistency", "turned_over", "hausdorff", "genus_right",
                  "components_right", "sharp_edges", "sharp_edges_restored", "topology_right"});
  EXPECT_EQ(names(json), members);
  EXPECT_EQ(json.at("interpolated").get<double>(), 100);
  EXPECT_EQ(json.at("f_score").get<double>(), 100);
  EXPECT_LT(json.at("hausdorff").get<double>(), 1e-12);
  EXPECT_TRUE(json.at("topology_right").get<bool>());
}

TEST(MeshReportProgram, WritesATable) {
  const ScratchFolder folder;
  Model open = box();
  open.triangles.resize(11);
  io::write_mesh(folder / "open.ply", open);
  const Outcome outcome =
      mesh_report({folder / "open.ply", "--truth", folder / "open.ply", "--points", folder / "open.ply"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::size_t count = 0, column = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const std::size_t gap = line.find("  ");
    ASSERT_NE(gap, std::string::npos) << line;
    const std::size_t value = line.find_first_not_of(' ', gap);
    if (count == 0) column = value;
    EXPECT_EQ(value, column) << line;
  }
  EXPECT_EQ(count, 26u);
  EXPECT_NE(outcome.out.find("no, 3 boundary edges\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("diameter 1.414, length 3.414, area 0.5,"), std::string::npos) << outcome.out;
}

TEST(MeshReportProgram, ListsHolesTheWidestFirst) {
  const ScratchFolder folder;
  Model open = box();
  open.triangles.erase(open.triangles.begin() + 4, open.triangles.begin() + 6);  // a side of the box
  open.triangles.erase(open.triangles.begin());                                  // half of another
  io::write_mesh(folder / "open.ply", open);
  const Json holes = Json::parse(mesh_report({folder / "open.ply", "--json"}).out).at("holes");
  ASSERT_EQ(holes.size(), 2u);
  EXPECT_NEAR(holes[0].at("diameter").get<double>(), std::sqrt(2), 1e-9);
  EXPECT_EQ(holes[0].at("edges").get<int>() + holes[1].at("edges").get<int>(), 7);
  double area = 0;
  for (const Json& hole : holes) area += hole.at("area").get<double>();
  EXPECT_DOUBLE_EQ(area, 1.5);
  EXPECT_EQ(holes[0].at("centre").size(), 3u);
}

TEST(MeshReportProgram, MeasuresWithAUnitOverAPlane) {
  const ScratchFolder folder;
  io::write_mesh(folder / "boxes.ply", joined(box({0, 0, 1}, {1, 1, 3}), box({4, 0, 0}, {5, 1, 1})));
  const std::vector<std::string> command = {folder / "boxes.ply", "--unit", "mm", "--ground", "0,0,2,-1"};
  const std::string text = mesh_report(command).out;
  for (const char* line :
       {"volume                      3 mm³", "component 1                 area 10 mm², volume 2 mm³",
        "volume above the ground     2.5 mm³"})
    EXPECT_NE(text.find(line), std::string::npos) << text;
  std::vector<std::string> as_json = command;
  as_json.emplace_back("--json");
  const Json json = Json::parse(mesh_report(as_json).out);
  EXPECT_EQ(json.at("unit").get<std::string>(), "mm");
  EXPECT_EQ(json.at("ground").get<std::vector<double>>(), (std::vector<double>{0, 0, 1, -0.5}));
  EXPECT_NEAR(json.at("volume_above").get<double>(), 2.5, 1e-12);
  EXPECT_NEAR(json.at("volume_below").get<double>(), 0.5, 1e-12);
  EXPECT_EQ(json.at("component_list").size(), 2u);
}

TEST(MeshReportProgram, FindsTheGroundOfAMesh) {
  const ScratchFolder folder;
  io::write_mesh(folder / "scene.ply",
                 joined(plane({-5, -5, 2}, {10, 0, 0}, {0, 10, 0}, 40), box({0, 0, 2.5}, {1, 1, 4.5})));
  const Outcome outcome = mesh_report({folder / "scene.ply", "--json", "--ground"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_NEAR(json.at("ground")[2].get<double>(), 1, 1e-6);
  EXPECT_NEAR(json.at("volume_above").get<double>(), 2, 1e-6);
}

TEST(MeshReportProgram, AMeshWithoutFacesHasAReport) {
  const ScratchFolder folder;
  std::ofstream(folder / "none.ply") << "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\n"
                                        "property float y\nproperty float z\nend_header\n";
  for (const std::string& mesh : {folder / "none.ply", std::string(TEST_DATA "/bun0.pcd")}) {
    io::write_mesh(folder / "box.ply", box());
    const Outcome outcome =
        mesh_report({mesh, "--json", "--truth", folder / "box.ply", "--points", folder / "box.ply"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(json.at("faces").get<int>(), 0);
    EXPECT_FALSE(json.at("closed").get<bool>());
    EXPECT_TRUE(json.at("genus").is_null());
    EXPECT_TRUE(json.at("chamfer_e3").is_null());
    EXPECT_EQ(json.at("interpolated").get<double>(), 0);
    EXPECT_FALSE(json.at("topology_right").get<bool>());
    EXPECT_EQ(mesh_report({mesh}).status, 0);
  }
}

TEST(MeshReportProgram, FailsInOneSentence) {
  const ScratchFolder folder;
  const std::string mesh = folder / "box.ply";
  io::write_mesh(mesh, box());
  std::ofstream(folder / "torn.ply") << "ply\nformat ascii 1.0\nelement vertex 9\n";
  std::ofstream(folder / "box.off") << "OFF\n";
  const std::vector<std::pair<int, std::vector<std::string>>> cases = {
      {2, {}},
      {2, {mesh, mesh}},
      {2, {mesh, "--nonsense"}},
      {2, {mesh, "--samples", "0"}},
      {2, {mesh, "--samples", "1000001"}},
      {2, {mesh, "--samples", "many"}},
      {2, {mesh, "--ground", "0,0,0,1"}},
      {2, {mesh, "--ground", "1,2"}},
      {2, {mesh, "--unit", "miles"}},
      {1, {folder / "missing.ply"}},
      {1, {folder / "torn.ply"}},
      {1, {folder / "box.off"}},
      {1, {folder.path().string()}},
      {1, {mesh, "--truth", folder / "missing.ply"}},
      {1, {mesh, "--truth", TEST_DATA "/bun0.pcd"}},
      {1, {mesh, "--truth", TEST_DATA "/spot_10k.ply"}},  // points only
      {1, {mesh, "--points", folder / "torn.ply"}},
  };
  for (const auto& [status, arguments] : cases) {
    const Outcome outcome = mesh_report(arguments);
    EXPECT_EQ(outcome.status, status);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("mesh_report: ", 0), 0u) << outcome.err;
    EXPECT_GT(outcome.err.size(), 25u);
  }
  EXPECT_EQ(mesh_report({"--help"}).status, 0);
}

/// The same figures from another program, evalmesh, where there is one.
TEST(MeshReportProgram, AgreesWithEvalmesh) {
  const char* named = std::getenv("FILMSTICKING_EVALMESH");
  const std::string evalmesh = named ? named : EVALMESH;
  if (evalmesh.empty()) GTEST_SKIP() << "FILMSTICKING_EVALMESH names no program";
  const ScratchFolder folder;
  Model open = torus();
  open.triangles.resize(2000);
  const Model shapes[] = {torus({0.01, 0, 0}), open, joined(torus(), torus({0.7, 0, 0.2})),
                          joined(box({-1, -1, -0.5}, {1, 1, 0}), box({-0.5, -0.5, -1}, {0.5, 0.5, 1}))};
  io::write_mesh(folder / "truth.ply", torus());
  for (const Model& shape : shapes) {
    io::write_mesh(folder / "mesh.ply", shape);
    const Outcome ours = mesh_report(
        {folder / "mesh.ply", "--json", "--truth", folder / "truth.ply", "--points", folder / "truth.ply"});
    const Outcome theirs =
        run_program({evalmesh, folder / "mesh.ply", folder / "truth.ply", folder / "truth.ply"});
    ASSERT_EQ(ours.status, 0) << ours.err;
    ASSERT_EQ(theirs.status, 0) << theirs.err;
    const Json a = Json::parse(ours.out), b = Json::parse(theirs.out);
    const std::pair<const char*, const char*> same[] = {{"vertices", "vertices"},
                                                        {"faces", "faces"},
                                                        {"boundary_edges", "boundary_edges"},
                                                        {"non_manifold_edges", "edges_over2"},
                                                        {"non_manifold_vertices", "nonmanifold_vertices"},
                                                        {"self_intersections", "si_pairs"},
                                                        {"components", "components"},
                                                        {"closed", "watertight"},
                                                        {"manifold", "manifold"},
                                                        {"oriented", "oriented"},
                                                        {"points", "points"}};
    for (const auto& [our, their] : same) EXPECT_EQ(a.at(our).dump(), b.at(their).dump()) << our;
    EXPECT_NEAR(a.at("interpolated").get<double>(), 100 * b.at("interpolated").get<double>(), 1e-3);
    EXPECT_NEAR(a.at("chamfer_e3").get<double>(), b.at("cd_l1").get<double>(), 1e-5);
    EXPECT_NEAR(a.at("f_score").get<double>(), b.at("f1").get<double>(), 1e-3);
    EXPECT_NEAR(a.at("hausdorff").get<double>(), b.at("hausdorff").get<double>(), 1e-5);
    // Where a point has two nearest faces, each takes the normal of one of them.
    EXPECT_NEAR(a.at("normal_consistency").get<double>(), b.at("nc").get<double>(), 1);
  }
}

}  // namespace
}  // namespace filmsticking::test
