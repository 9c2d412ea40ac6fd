// SPDX-License-Identifier: GPL-3.0-or-later
// pcd_to_mesh as a user runs it, on real clouds.
#include "support/pcd_to_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "filters/filter_chain.h"
#include "io/formats.h"

namespace filmsticking::test {
namespace {

namespace fs = std::filesystem;

TEST(PcdToMesh, MakesAMeshOfBun0) {
  const ScratchFolder folder;
  const Outcome outcome = pcd_to_mesh({kBunny, folder / "bunny.ply"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");  // no progress bar off a terminal
  EXPECT_NE(outcome.out.find("397 points"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("closed  yes, manifold"), std::string::npos) << outcome.out;
  expect_surface_through(io::read_mesh(folder / "bunny.ply"), io::read_cloud(kBunny));
  EXPECT_EQ(folder.count(), 1u);
}

TEST(PcdToMesh, MakesAMeshOfSpot) {
  const ScratchFolder folder;
  const Outcome outcome = pcd_to_mesh({kSpot, folder / "spot.ply", "--report", folder / "spot.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Model mesh = io::read_mesh(folder / "spot.ply");
  expect_surface_through(mesh, io::read_cloud(kSpot));
  EXPECT_GT(mesh.positions.size(), 9900u);

  const Json report = read_json(folder / "spot.json");
  EXPECT_EQ(report.at("status").get<std::string>(), "Ok");
  EXPECT_EQ(report.at("message").get<std::string>(), "");
  EXPECT_EQ(report.at("points").get<int>(), 10000);
  EXPECT_EQ(report.at("sites").get<int>(), 10000);
  EXPECT_EQ(report.at("vertices").get<std::size_t>(), mesh.positions.size());
  EXPECT_EQ(report.at("triangles").get<std::size_t>(), mesh.triangles.size());
  EXPECT_EQ(report.at("interpolated").get<int>(), report.at("vertices").get<int>());
  EXPECT_GT(report.at("interpolated_share").get<double>(), 0.99);
  EXPECT_TRUE(report.at("closed").get<bool>());
  EXPECT_TRUE(report.at("manifold").get<bool>());
  EXPECT_EQ(report.at("genus").get<int>(), 0);
  EXPECT_EQ(report.at("components").get<int>(), 1);
  EXPECT_GT(report.at("seconds").get<double>(), 0);
  EXPECT_GT(report.at("peak_memory_bytes").get<double>(), 1e6);
  EXPECT_EQ(report.at("steps").size(), 0u);  // a carved surface needs no film steps
  ASSERT_GT(report.at("rooms").size(), 0u);
  for (const Json& stage : report.at("rooms")) EXPECT_NE(stage.at("room").get<std::string>(), "");
}

TEST(PcdToMesh, HolesAreClosedUpToADiameter) {
  const ScratchFolder folder;
  Model ball;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  while (ball.positions.size() < 6000) {
    const double x = normal(random), y = normal(random), z = normal(random), r = std::hypot(x, y, z);
    if (std::hypot(x, y) > (z > 0 ? 0.3 : 0.6) * r) ball.positions.push_back({x / r, y / r, z / r});
  }
  io::write_mesh(folder / "ball.ply", ball);
  // The diagonal of the box is about 3.4.
  const std::pair<const char*, int> cases[] = {{"0.4", 2}, {"0.9", 1}, {"12%", 2}, {"27%", 1}, {"50%", 0}};
  for (const auto& [most, open] : cases) {
    SCOPED_TRACE(most);
    const Outcome outcome = pcd_to_mesh({folder / "ball.ply", folder / "mesh.ply", "--close-holes", most,
                                         "--report", folder / "report.json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Json report = read_json(folder / "report.json");
    EXPECT_EQ(report.at("boundary_loops").get<int>(), open);
    ASSERT_EQ(report.at("holes").size(), 2u);
    EXPECT_EQ(report.at("holes")[0].at("closed").get<bool>(), open == 0);
    EXPECT_EQ(outcome.out.find("lids") == std::string::npos, open == 2) << outcome.out;
  }
  for (const char* wrong : {"0", "-1", "x", "", "1,2", "inf", "%"})
    EXPECT_EQ(pcd_to_mesh({folder / "ball.ply", folder / "m.ply", "--close-holes", wrong}).status, 2)
        << wrong;
}

TEST(PcdToMesh, TheMeshDoesNotDependOnTheThreads) {
  const ScratchFolder folder;
  ASSERT_EQ(pcd_to_mesh({kBunny, folder / "one.ply", "--threads", "1"}).status, 0);
  ASSERT_EQ(pcd_to_mesh({kBunny, folder / "two.ply", "--threads=2"}).status, 0);
  EXPECT_TRUE(io::read_file(folder / "one.ply") == io::read_file(folder / "two.ply"));
}

TEST(PcdToMesh, DumpsTheFilmOfEachStep) {
  const ScratchFolder folder;
  const Outcome outcome = pcd_to_mesh({kBunny, folder / "mesh.ply", "--init", "sphere", "--dump-steps",
                                       folder / "new/steps", "--report", folder / "report.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json report = read_json(folder / "report.json");
  ASSERT_GT(report.at("steps").size(), 0u);
  for (const Json& step : report.at("steps")) {
    for (const char* field : {"round", "attracted", "virtual_left", "weighted", "held"})
      EXPECT_GE(step.at(field).get<int>(), 0);
    EXPECT_GE(step.at("seconds").get<double>(), 0);
  }
  EXPECT_TRUE(fs::exists(folder / "new/steps/step_000.ply"));
  EXPECT_TRUE(fs::exists(folder / "new/steps/step_001.ply"));
  for (const auto& entry : fs::directory_iterator(folder / "new/steps")) {
    // A film is closed: every edge is run through as often in either direction. It may touch itself.
    const Model film = io::read_mesh(entry.path().string());
    std::map<std::pair<Point, Point>, int> edges;
    for (const Triangle& t : film.triangles)
      for (int k = 0; k < 3; ++k) {
        const Point &from = film.positions[t[k]], &to = film.positions[t[(k + 1) % 3]];
        ++edges[{from, to}], --edges[{to, from}];
      }
    EXPECT_FALSE(edges.empty()) << entry.path();
    for (const auto& [edge, count] : edges) ASSERT_EQ(count, 0) << entry.path();
  }
}

TEST(PcdToMesh, FiltersRunBeforeTheSurface) {
  const ScratchFolder folder;
  const std::string milk = TEST_DATA "/milk.pcd";
  filters::FilterOptions wanted;
  set_filter(wanted, "crop", "-1,-1,0.5,1,1,2");
  set_filter(wanted, "sor", "16,2");
  set_filter(wanted, "voxel", "0.006");
  const Model left = filters::filter(io::read_cloud(milk).points, wanted);
  ASSERT_GT(left.positions.size(), 500u);

  const Outcome outcome =
      pcd_to_mesh({milk, folder / "mesh.ply", "--voxel=0.006", "--crop", "-1,-1,0.5,1,1,2", "--sor", "16,2",
                   "--report", folder / "report.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  expect_surface_through(io::read_mesh(folder / "mesh.ply"), left);
  const Json report = read_json(folder / "report.json");
  EXPECT_EQ(report.at("read").get<std::size_t>(), 13704u);
  EXPECT_EQ(report.at("points").get<std::size_t>(), left.positions.size());
  EXPECT_NE(outcome.out.find(std::to_string(left.positions.size()) + " after crop, sor, voxel"),
            std::string::npos)
      << outcome.out;

  expect_failure({milk, folder / "no.ply", "--voxel", "1e-7"}, folder, 1);
  expect_failure({milk, folder / "no.ply", "--crop", "8,8,8,9,9,9"}, folder, 1);
}

TEST(PcdToMesh, AViewpointIsThatOfAPcdFileOrGiven) {
  const ScratchFolder folder;
  const std::string milk = TEST_DATA "/milk.pcd";
  Model bare = io::read_cloud(milk);
  ASSERT_TRUE(bare.viewpoint);
  io::write_mesh(folder / "milk.ply", bare);
  const auto mesh = [&](std::vector<std::string> words) {
    words.insert(words.begin() + 1, folder / "mesh.ply");
    words.insert(words.end(), {"--open", "--voxel", "0.004"});
    const Outcome outcome = pcd_to_mesh(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Model(io::read_mesh(folder / "mesh.ply")).triangles;
  };
  EXPECT_EQ(mesh({folder / "milk.ply", "--viewpoint", "0,0,0"}), mesh({milk}));
  EXPECT_NE(mesh({folder / "milk.ply"}), mesh({milk}));
  EXPECT_EQ(mesh({milk, "--viewpoint=9,9,9"}), mesh({folder / "milk.ply"}));
  for (const char* wrong : {"1,2", "1,2,3,4", "x", "1,2,nan", ""})
    expect_failure({milk, folder / "no.ply", "--viewpoint", wrong}, folder, 2);
}

TEST(PcdToMesh, AnOpenScanKeepsItsBorder) {
  const ScratchFolder folder;
  const std::string milk = TEST_DATA "/milk.pcd";
  const Outcome outcome = pcd_to_mesh(
      {milk, folder / "mesh.ply", "--open", "--voxel", "0.004", "--report", folder / "report.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("closed  no, "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(", manifold"), std::string::npos) << outcome.out;
  const Json report = read_json(folder / "report.json");
  EXPECT_FALSE(report.at("closed").get<bool>());
  EXPECT_GT(report.at("boundary_loops").get<int>(), 0);
  // Edges of one face only, counted anew.
  std::map<std::pair<int, int>, int> faces_of;
  for (const Triangle& t : Model(io::read_mesh(folder / "mesh.ply")).triangles)
    for (int k = 0; k < 3; ++k) ++faces_of[std::minmax(t[k], t[(k + 1) % 3])];
  int open = 0;
  for (const auto& [edge, faces] : faces_of) {
    EXPECT_LE(faces, 2);
    open += faces == 1 ? 1 : 0;
  }
  EXPECT_EQ(report.at("boundary_edges").get<int>(), open);
}

TEST(PcdToMesh, OutliersAreLeftOffUnlessKept) {
  const ScratchFolder folder;
  Model cloud = io::read_cloud(kSpot);
  cloud.positions.resize(3000);
  const Point stray{9, 9, 9};
  cloud.positions.push_back(stray);
  io::write_mesh(folder / "cloud.ply", cloud);
  const Outcome outcome = pcd_to_mesh({folder / "cloud.ply", folder / "mesh.ply"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("1 outlier left out"), std::string::npos) << outcome.out;
  const Model mesh = io::read_mesh(folder / "mesh.ply");
  EXPECT_EQ(std::count(mesh.positions.begin(), mesh.positions.end(), stray), 0);
  const Outcome kept = pcd_to_mesh({folder / "cloud.ply", folder / "kept.ply", "--keep-outliers"});
  EXPECT_EQ(kept.status, 0) << kept.err;
  EXPECT_EQ(kept.out.find("outlier"), std::string::npos) << kept.out;
}

TEST(PcdToMesh, AFailedRunKeepsTheOldMeshAndReports) {
  const ScratchFolder folder;
  std::ofstream(folder / "flat.xyz") << "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 1 0\n";
  std::ofstream(folder / "mesh.ply") << "an old mesh";
  const Outcome outcome =
      pcd_to_mesh({folder / "flat.xyz", folder / "mesh.ply", "--report", folder / "report.json"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(io::read_file(folder / "mesh.ply"), "an old mesh");
  const Json report = read_json(folder / "report.json");
  EXPECT_EQ(report.at("status").get<std::string>(), "Coplanar");
  EXPECT_NE(report.at("message").get<std::string>(), "");
  EXPECT_EQ(report.at("triangles").get<int>(), 0);
}

TEST(PcdToMesh, InterruptionEndsItCleanly) {
  // Enough noisy points to be busy for long after the first film step.
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Model cloud;
  for (int i = 0; i < 60000; ++i) {
    Point p{normal(random), normal(random), normal(random)};
    const double scale = (1 + 0.02 * normal(random)) / std::hypot(p[0], p[1], p[2]);
    for (double& x : p) x *= scale;
    cloud.positions.push_back(p);
  }
  const ScratchFolder folder;
  io::write_mesh(folder / "cloud.ply", cloud);
  const fs::path steps = folder / "steps";
  const Outcome outcome = pcd_to_mesh(
      {folder / "cloud.ply", folder / "mesh.ply", "--dump-steps", steps.string()}, [&](pid_t program) {
        const auto has_begun = [&] { return fs::is_directory(steps) && !fs::is_empty(steps); };
        for (int i = 0; i < 6000 && !has_begun(); ++i)
          std::this_thread::sleep_for(std::chrono::milliseconds(10));
        kill(program, SIGINT);
      });
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "mesh.ply"));
  EXPECT_EQ(folder.count(), 2u);  // the cloud and the steps
}

}  // namespace
}  // namespace filmsticking::test
