// SPDX-License-Identifier: GPL-3.0-or-later
// capture_to_mesh as a user runs it: on range images of a mesh with known poses, and on real scans.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <thread>

#include "filmsticking/reconstruct.h"
#include "io/files.h"
#include "io/formats.h"
#include "stream/trajectory.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"
#include "support/surface_check.h"
#include "tools/stream/turntable.h"

namespace filmsticking::test {
namespace {

namespace fs = std::filesystem;

const std::string kBun0 = TEST_DATA "/bun0.pcd", kBun4 = TEST_DATA "/bun4.pcd";

Outcome capture_to_mesh(std::vector<std::string> arguments,
                        const std::function<void(pid_t)>& while_running = nullptr) {
  arguments.insert(arguments.begin(), CAPTURE_TO_MESH);
  return run_program(arguments, while_running);
}

void expect_failure(const std::vector<std::string>& arguments, int status) {
  const Outcome outcome = capture_to_mesh(arguments);
  EXPECT_EQ(outcome.status, status) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("capture_to_mesh: ", 0), 0u) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

std::vector<Point> read_points(const std::string& path) {
  return io::positions_of(io::read_cloud(path).points);
}

Mesh read_mesh(const std::string& path) {
  const pcl::PolygonMesh mesh = io::read_mesh(path);
  return {io::positions_of(mesh.cloud), io::triangles_of(mesh.polygons)};
}

void write_mesh(const std::string& path, const Mesh& mesh) {
  io::write_mesh(path, io::make_cloud(mesh.positions), mesh.triangles);
}

void expect_closed(const std::string& path) { EXPECT_EQ(surface_fault(read_mesh(path)), ""); }

/// mesh_report's comparison of two meshes, in the box of the truth whose longest side is 1.
nlohmann::json compare(const std::string& mesh, const std::string& truth) {
  const Outcome outcome = run_program({MESH_REPORT, mesh, "--truth", truth, "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

std::vector<stream::Pose> poses_of(const std::string& path) {
  const stream::Trajectory trajectory = stream::parse_trajectory(io::read_file(path));
  std::vector<stream::Pose> poses;
  for (std::size_t k = 0; k < trajectory.size(); ++k) poses.push_back(trajectory[k]);
  return poses;
}

/// A turntable capture of Spot, made once: a mesh as the truth, range images with and without their poses.
class Turntable : public ::testing::Test {
 protected:
  static constexpr int kSteps = 14;
  static constexpr double kPitch = 0.025;  // Spot is 1.7 high

  static void SetUpTestSuite() {
    folder_ = std::make_unique<ScratchFolder>();
    const std::vector<Point> cloud = read_points(TEST_DATA "/spot_10k.ply");
    const Result result = reconstruct(cloud);
    ASSERT_EQ(result.status, Status::Ok);
    Mesh truth;
    for (const std::int32_t k : result.vertices) truth.positions.push_back(cloud[k]);
    truth.triangles = result.triangles;
    write_mesh(file("truth.ply"), truth);
    fs::create_directory(file("plain"));
    fs::create_directory(file("posed"));
    std::string trajectory;
    int number = 0;
    for (const RangeImage& image : turntable(truth, kSteps, kPitch)) {
      const std::string name = "/scan_" + std::to_string(number) + ".pcd";
      write_pcd(file("plain") + name, image.points);
      write_pcd(file("posed") + name, image.points, &image.pose);
      trajectory += stream::trajectory_line(number++, image.pose);
    }
    io::write_file(file("poses.txt"), trajectory);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string file(const std::string& name) { return *folder_ / name; }

  /// As near to the truth as the rays are apart.
  static void expect_spot(const std::string& mesh) {
    expect_closed(mesh);
    const auto report = compare(mesh, file("truth.ply"));
    EXPECT_EQ(report.at("genus").get<int>(), 0);
    EXPECT_EQ(report.at("components").get<int>(), 1);
    EXPECT_LT(report.at("chamfer_e3").get<double>(), 1000 * kPitch / 1.7 / 8);
    EXPECT_LT(report.at("hausdorff").get<double>(), kPitch / 1.7);
    EXPECT_GT(report.at("normal_consistency").get<double>(), 97);
  }

 private:
  static std::unique_ptr<ScratchFolder> folder_;
};
std::unique_ptr<ScratchFolder> Turntable::folder_;

TEST_F(Turntable, WithATrajectory) {
  const Outcome outcome = capture_to_mesh(
      {file("plain"), file("given.ply"), "--poses", file("poses.txt"), "--save-cloud", file("cloud.ply")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("28 used, 0 left out"), std::string::npos) << outcome.out;
  expect_spot(file("given.ply"));
  EXPECT_GE(read_points(file("cloud.ply")).size(), read_points(file("given.ply")).size());

  // The fused cloud says where its points were seen from.
  std::set<Point> sensors;
  for (const stream::Pose& pose : poses_of(file("poses.txt")))
    sensors.insert({pose.translation().x(), pose.translation().y(), pose.translation().z()});
  const std::vector<Point> seen_from = io::read_cloud(file("cloud.ply")).viewpoints;
  ASSERT_EQ(seen_from.size(), read_points(file("cloud.ply")).size());
  for (const Point& p : seen_from) ASSERT_EQ(sensors.count(p), 1u) << p[0] << " " << p[1] << " " << p[2];
}

TEST_F(Turntable, WithTheCloudsOwnPoses) {
  const Outcome outcome = capture_to_mesh({file("posed"), file("sensor.ply")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  expect_spot(file("sensor.ply"));
}

TEST_F(Turntable, ByRegistration) {
  const Outcome outcome =
      capture_to_mesh({file("plain"), file("found.ply"), "--save-poses", file("found.txt"), "--every", "5"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("28 used, 0 left out"), std::string::npos) << outcome.out << outcome.err;

  // The found poses begin with the identity; the true ones are relative to their first, too.
  const auto truth = stream::parse_trajectory(io::read_file(file("poses.txt")));
  const auto found = stream::parse_trajectory(io::read_file(file("found.txt")));
  ASSERT_EQ(found.size(), truth.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const stream::Pose error = (truth[0].inverse() * truth[k]).inverse() * found[k];
    EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), 0.03) << k;
  }

  // So is the mesh.
  Mesh mesh = read_mesh(file("found.ply"));
  for (Point& p : mesh.positions) {
    const Eigen::Vector3d q = truth[0] * Eigen::Vector3d(p[0], p[1], p[2]);
    p = {q.x(), q.y(), q.z()};
  }
  write_mesh(file("found_moved.ply"), mesh);
  expect_closed(file("found_moved.ply"));
  const auto report = compare(file("found_moved.ply"), file("truth.ply"));
  EXPECT_LT(report.at("chamfer_e3").get<double>(), 1000 * kPitch / 1.7 / 6);
  EXPECT_LT(report.at("hausdorff").get<double>(), 1.5 * kPitch / 1.7);
}

TEST_F(Turntable, FiltersAndStrides) {
  const Outcome outcome =
      capture_to_mesh({file("posed"), file("some.ply"), "--stride", "2", "--frames", "9", "--sor", "8,2",
                       "--crop", "-9,-9,0,9,9,9", "--seen-by", "2", "--mls", "0.08", "--max-points", "2000"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("9 used"), std::string::npos) << outcome.out;
  expect_closed(file("some.ply"));
  EXPECT_LE(read_points(file("some.ply")).size(), 2000u);
  EXPECT_EQ(capture_to_mesh({file("posed"), file("none.ply"), "--crop", "0,0,-9,1,1,-8"}).status, 1);
}

TEST_F(Turntable, InterruptedItMeshesWhatThereIs) {
  // The first fits take their time, so that it is still at work when the first preview is there.
  const std::string mesh = file("interrupted.ply");
  const Outcome outcome =
      capture_to_mesh({file("plain"), mesh, "--every", "1", "--align", "gicp"}, [&](pid_t program) {
        for (int i = 0; i < 6000 && !fs::exists(mesh); ++i)
          std::this_thread::sleep_for(std::chrono::milliseconds(10));
        kill(program, SIGINT);
      });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("interrupted"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("after 1 frame"), std::string::npos) << outcome.err;
  expect_closed(mesh);
}

TEST(CaptureToMesh, PlaysTheBundledRecording) {
  const ScratchFolder folder;
  const std::string recording = TEST_DATA "/spot_turntable";
  const Outcome outcome =
      capture_to_mesh({recording, folder / "mesh.glb", "--poses", recording + "/poses.txt", "--save-cloud",
                       folder / "cloud.ply", "--save-poses", folder / "poses.txt"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("24 used, 0 left out"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("closed  yes, manifold\ngenus   0, 1 component"), std::string::npos)
      << outcome.out;
  EXPECT_EQ(io::read_file(folder / "poses.txt"), io::read_file(recording + "/poses.txt"));
  // Another sampling of the same model: its points are on the fused surface.
  const std::vector<Point> fused = read_points(folder / "cloud.ply"),
                           spot = read_points(TEST_DATA "/spot_10k.ply");
  std::size_t near = 0;
  for (std::size_t i = 0; i < spot.size(); i += 20)
    near += std::any_of(fused.begin(), fused.end(), [&](const Point& p) {
      const Point& q = spot[i];
      return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < 0.05;
    });
  EXPECT_GT(near, spot.size() / 20 * 98 / 100);
}

TEST(CaptureToMesh, FitsTwoRealScans) {
  const ScratchFolder folder;
  const Outcome outcome = capture_to_mesh(
      {kBun0, kBun4, folder / "bunny.ply", "--save-poses", folder / "poses.txt", "--fuse", "0.002"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("2 used, 0 left out"), std::string::npos) << outcome.out;
  expect_closed(folder / "bunny.ply");
  // The tests of PCL's ICP know the angle between them.
  const auto poses = stream::parse_trajectory(io::read_file(folder / "poses.txt"));
  EXPECT_NEAR(Eigen::AngleAxisd(poses[1].linear()).angle(), 0.494, 0.15);
}

TEST(CaptureToMesh, FramesThatCannotBeUsedAreLeftOut) {
  const ScratchFolder folder;
  std::ofstream(folder / "scan_2.pcd") << "noise";
  fs::copy_file(kBun0, folder / "scan_1.pcd");
  fs::copy_file(TEST_DATA "/lamppost.pcd", folder / "scan_3.pcd");
  const Outcome outcome = capture_to_mesh({folder.path().string(), folder / "mesh.ply"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("1 used, 2 left out"), std::string::npos) << outcome.out;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 2) << outcome.err;
  EXPECT_NE(outcome.err.find("scan_2.pcd"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("scan_3.pcd"), std::string::npos) << outcome.err;
}

TEST(CaptureToMesh, HelpGoesToStdout) {
  const Outcome outcome = capture_to_mesh({"--help"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* option : {"--device", "--poses", "--align", "--every", "--stride", "--frames", "--fuse",
                             "--seen-by", "--max-points", "--min-overlap", "--save-poses", "--save-cloud",
                             "--voxel", "--sor", "--crop", "--mls", "--threads", "OpenNI2"})
    EXPECT_NE(outcome.out.find(option), std::string::npos) << option;
  EXPECT_EQ(capture_to_mesh({"--version"}).status, 0);
}

TEST(CaptureToMesh, WrongCommandLinesFailInOneSentence) {
  const ScratchFolder folder;
  const std::string mesh = folder / "mesh.ply";
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {},
           {kBun0},
           {kBun0, ""},
           {kBun0, mesh, "--device", "#1"},
           {kBun0, mesh, "--align", "magnet"},
           {kBun0, mesh, "--poses", "p.txt", "--align", "icp"},
           {kBun0, mesh, "--every", "0"},
           {kBun0, mesh, "--stride", "0"},
           {kBun0, mesh, "--frames", "x"},
           {kBun0, mesh, "--fuse", "-1"},
           {kBun0, mesh, "--fuse", "nan"},
           {kBun0, mesh, "--min-overlap", "2"},
           {kBun0, mesh, "--max-points", "0"},
           {kBun0, mesh, "--seen-by", "0"},
           {kBun0, mesh, "--voxel", "0"},
           {kBun0, mesh, "--nonsense"},
       })
    expect_failure(arguments, 2);
  EXPECT_EQ(folder.count(), 0u);
}

TEST(CaptureToMesh, BadFilesFailInOneSentence) {
  const ScratchFolder folder;
  const std::string mesh = folder / "mesh.ply";
  std::ofstream(folder / "noise.oni") << "noise";
  std::ofstream(folder / "noise.txt") << "noise";
  std::ofstream(folder / "flat.pcd")
      << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 5\nHEIGHT 1\nPOINTS 5\n"
         "DATA ascii\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 1 0\n";
  fs::create_directory(folder / "empty");
  expect_failure({folder / "missing.pcd", mesh}, 1);
  expect_failure({folder / "empty", mesh}, 1);
  expect_failure({folder / "noise.oni", mesh}, 1);
  expect_failure({folder / "noise.txt", mesh}, 1);
  expect_failure({folder / "flat.pcd", mesh}, 1);
  expect_failure({kBun0, folder / "mesh.foo"}, 1);
  expect_failure({kBun0, folder / "no/such/mesh.ply"}, 1);
  expect_failure({kBun0, mesh, "--poses", folder / "noise.txt"}, 1);
  expect_failure({kBun0, mesh, "--poses", folder / "missing.txt"}, 1);
  expect_failure({kBun0, mesh, "--save-poses", folder / "no/such/poses.txt"}, 1);
  EXPECT_FALSE(fs::exists(mesh));
}

/// Real range images, where a folder of them is at hand: twelve of a turntable in one file, one after the
/// other, in world coordinates.
TEST(CaptureToMesh, FitsTheScansOfARealTurntable) {
  const std::string path = std::string(MORE_DATA) + "/scans/armadillo_range.ply";
  if (std::string(MORE_DATA).empty() || !fs::exists(path))
    GTEST_SKIP() << "FILMSTICKING_DATA has no such scan";
  const std::vector<Point> cloud = read_points(path);
  const ScratchFolder folder;
  // Between two images the scan jumps to the other end of the figure.
  std::vector<std::vector<Eigen::Vector3d>> images(1);
  for (const Point& p : cloud) {
    const Eigen::Vector3d q(p[0], p[1], p[2]);
    if (images.back().size() > 5000 && (q - images.back().back()).norm() > 0.244) images.emplace_back();
    images.back().push_back(q);
  }
  ASSERT_GE(images.size(), 10u);
  std::vector<stream::Pose> truth;
  for (std::size_t k = 0; k < images.size(); ++k) {
    truth.emplace_back(Eigen::AngleAxisd(2 * M_PI * static_cast<double>(k) / 12, Eigen::Vector3d::UnitY()));
    for (Eigen::Vector3d& p : images[k]) p = truth[k].inverse() * p;
    write_pcd(folder / ("scan_" + std::to_string(k) + ".pcd"), images[k]);
  }
  const Outcome outcome = capture_to_mesh(
      {folder.path().string(), folder / "mesh.ply", "--save-poses", folder / "poses.txt", "--fuse", "0.002"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  expect_closed(folder / "mesh.ply");
  const auto found = stream::parse_trajectory(io::read_file(folder / "poses.txt"));
  ASSERT_EQ(found.size(), truth.size()) << outcome.err;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const stream::Pose error = truth[k].inverse() * found[k];
    EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), 0.04) << k;
    EXPECT_LT(error.translation().norm(), 0.005) << k;  // of a figure of 0.2
  }
}

}  // namespace
}  // namespace filmsticking::test
