// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a capture one by one.
#include <gtest/gtest.h>

#include <cmath>
#include <condition_variable>
#include <fstream>
#include <map>
#include <mutex>

#include "io/files.h"
#include "stream/accumulator.h"
#include "stream/background_mesher.h"
#include "stream/capture_error.h"
#include "stream/frame_points.h"
#include "stream/frame_source.h"
#include "stream/pose_source.h"
#include "stream/strict_pcd.h"
#include "stream/trajectory.h"
#include "stream/voxel_map.h"
#include "support/clouds.h"
#include "support/scratch_folder.h"
#include "turntable.h"

namespace filmsticking::capture {
namespace {

using io::Model;
using test::ScratchFolder;

const std::string kBun0 = TEST_DATA "/bun0.pcd", kBun4 = TEST_DATA "/bun4.pcd";

Pose pose(double x, double y, double z, double angle, const Eigen::Vector3d& axis) {
  return Pose(Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(angle, axis.normalized()));
}

/// Rotation in radians and shift between two poses.
std::pair<double, double> difference(const Pose& a, const Pose& b) {
  const Pose between = a.inverse() * b;
  return {Eigen::AngleAxisd(between.linear()).angle(), between.translation().norm()};
}

TEST(Trajectory, IsReadAndInterpolated) {
  const Trajectory poses = parse_trajectory(
      "# a comment\n1 0 0 0 0 0 0 1\n\n1.1 1 2 3 0 0 0.70710678 0.70710678\n9 5 5 5 1 0 0 0\n");
  ASSERT_EQ(poses.size(), 3u);
  EXPECT_TRUE(poses.at(1)->isApprox(Pose::Identity(), 1e-7));
  EXPECT_TRUE(poses.at(1.1)->isApprox(pose(1, 2, 3, M_PI / 2, {0, 0, 1}), 1e-7));
  EXPECT_TRUE(poses.at(1.05)->isApprox(pose(0.5, 1, 1.5, M_PI / 4, {0, 0, 1}), 1e-7));
  EXPECT_TRUE(poses.at(9)->isApprox(pose(5, 5, 5, M_PI, {1, 0, 0}), 1e-7));
  EXPECT_FALSE(poses.at(0.9));
  EXPECT_FALSE(poses.at(5));  // too far from both
  EXPECT_FALSE(poses.at(9.1));
}

TEST(Trajectory, WhatIsWrittenReadsBack) {
  const Pose wanted = pose(-1.5, 2e3, 0.001, 2.5, {1, -2, 3});
  const auto read = parse_trajectory(trajectory_line(12.25, wanted)).at(12.25);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->isApprox(wanted, 1e-7));
}

TEST(Trajectory, NonsenseIsRefused) {
  for (const char* text : {"", "# nothing\n", "1 2 3\n", "1 0 0 0 0 0 0 2\n", "1 0 0 0 0 0 0 0\n",
                           "1 nan 0 0 0 0 0 1\n", "hello\n", "2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n"})
    EXPECT_THROW(parse_trajectory(text), CaptureError) << text;
}

TEST(FileNames, AreSortedByTheirNumbers) {
  const ScratchFolder folder;
  for (const char* name : {"scan_10.pcd", "scan_2.pcd", "scan_1.PCD", "notes.txt", "scan_002b.pcd"})
    std::ofstream(folder / name) << "x";
  const std::vector<std::string> expected = {folder / "scan_1.PCD", folder / "scan_2.pcd",
                                             folder / "scan_002b.pcd", folder / "scan_10.pcd"};
  EXPECT_EQ(pcd_files_in(folder.path().string()), expected);
  EXPECT_THROW(pcd_files_in(folder / "missing"), CaptureError);
  const ScratchFolder empty;
  EXPECT_THROW(pcd_files_in(empty.path().string()), CaptureError);
}

TEST(FileNames, TellTheTime) {
  EXPECT_EQ(time_in_name("a/1305031102.175304.pcd"), 1305031102.175304);
  EXPECT_EQ(time_in_name("scan_007.pcd"), 7);
  EXPECT_EQ(time_in_name("v2.scan.5.pcd"), 5);
  EXPECT_FALSE(time_in_name("cloud.pcd"));
  EXPECT_FALSE(time_in_name("scan_1b.pcd"));
}

TEST(VoxelMap, GivesTheMeanOfEachCell) {
  test::Random random(1);
  VoxelMap map(0.5, 1000);
  std::map<std::array<int, 3>, std::pair<Point, int>> cells;
  for (int frame = 0; frame < 3; ++frame) {
    Model points;
    for (int i = 0; i < 500; ++i) {
      const Point p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      points.positions.push_back(p);
      auto& [sum, count] =
          cells[{int(std::floor(p[0] * 2)), int(std::floor(p[1] * 2)), int(std::floor(p[2] * 2))}];
      for (int axis = 0; axis < 3; ++axis) sum[axis] += p[axis];
      ++count;
    }
    points.positions.push_back({NAN, 0, 0});
    points.positions.push_back({1e300, 0, 0});
    map.add(points);
  }
  ASSERT_EQ(map.size(), cells.size());
  for (const Point& p : map.points().positions) {
    const auto& [sum, count] =
        cells.at({int(std::floor(p[0] * 2)), int(std::floor(p[1] * 2)), int(std::floor(p[2] * 2))});
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(p[axis], sum[axis] / count, 1e-12);
  }
}

TEST(VoxelMap, GetsCoarserInsteadOfLarger) {
  const Model points{test::sphere(20000, 2), {}, {}};
  VoxelMap small(0.01, 1000), coarse(0.01, 1000000);
  small.add(points);
  EXPECT_LE(small.size(), 1000u);
  EXPECT_GT(small.size(), 200u);
  const double factor = small.leaf() / 0.01;
  EXPECT_EQ(factor, std::exp2(std::round(std::log2(factor))));
  // The same cells as those of a map that was as coarse from the start.
  VoxelMap same(small.leaf(), 1000000);
  same.add(points);
  ASSERT_EQ(same.size(), small.size());
  std::map<std::array<long, 3>, Point> mean;
  const auto cell = [&](const Point& p) {
    return std::array<long, 3>{std::lround(std::floor(p[0] / small.leaf())),
                               std::lround(std::floor(p[1] / small.leaf())),
                               std::lround(std::floor(p[2] / small.leaf()))};
  };
  for (const Point& p : same.points().positions) mean[cell(p)] = p;
  for (const Point& p : small.points().positions)
    for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(p[axis], mean.at(cell(p))[axis], 1e-12);
}

TEST(VoxelMap, CountsFramesAndMixesColours) {
  VoxelMap map(1, 100);
  map.add({{{0.5, 0.5, 0.5}, {0.6, 0.5, 0.5}, {2.5, 0, 0}}, {{0, 10, 255}, {0, 10, 255}, {1, 1, 1}}, {}});
  EXPECT_EQ(map.points(2).positions.size(), 0u);  // two points of one frame are one frame
  map.add({{{0.7, 0.5, 0.5}, {0.6, 0.5, 0.5}}, {{200, 10, 255}, {200, 10, 255}}, {}});
  const Model twice = map.points(2);
  ASSERT_EQ(twice.positions.size(), 1u);
  EXPECT_NEAR(twice.positions[0][0], 0.6, 1e-12);
  EXPECT_EQ(twice.colours[0], (io::Colour{100, 10, 255}));
  map.add({{{9, 9, 9}}, {}, {}});  // without a colour
  EXPECT_TRUE(map.points().colours.empty());
}

TEST(PcdSequence, PlaysFilesAndGoesOnBehindBrokenOnes) {
  const ScratchFolder folder;
  std::ofstream(folder / "broken_1.pcd") << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                                            "WIDTH 1000000000\nHEIGHT 1\nPOINTS 1000000000\nDATA binary\n12";
  const Pose viewpoint = pose(1, -2, 3, 1.2, {1, 1, 0});
  test::write_pcd(folder / "scan_2.5.pcd", {{1, 2, 3}, {4, 5, 6}}, &viewpoint);
  const auto source = pcd_sequence({kBun0, folder / "broken_1.pcd", folder / "scan_2.5.pcd"});
  EXPECT_EQ(source->size(), 3u);
  const auto bunny = source->next();
  ASSERT_TRUE(bunny);
  EXPECT_EQ(bunny->name, "bun0.pcd");
  EXPECT_EQ(bunny->time, 0);
  EXPECT_EQ(bunny->cloud.width, 397u);
  EXPECT_TRUE(bunny->sensor_pose.isApprox(Pose::Identity()));
  EXPECT_THROW(source->next(), CaptureError);
  const auto scan = source->next();
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->time, 2.5);
  EXPECT_TRUE(scan->sensor_pose.isApprox(viewpoint, 1e-6));
  EXPECT_EQ(frame_points(*scan, {}).positions, (std::vector<Point>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_TRUE(source->at_end());
  EXPECT_FALSE(source->next());
}

TEST(StrictPcd, RefusesWhatPclsReaderDoesNotStand) {
  const std::vector<std::string> lines = {
      "VERSION 0.7", "FIELDS x y z", "SIZE 4 4 4", "TYPE F F F",
      "COUNT 1 1 1", "WIDTH 2",      "HEIGHT 1",   "VIEWPOINT 0 0 0 1 0 0 0",
      "POINTS 2",    "DATA ascii",   "1 2 3",      "4 5 6"};
  const auto file = [](const std::vector<std::string>& of) {
    std::string text = "# .PCD v0.7\n";
    for (const std::string& line : of) text += line + "\n";
    return text;
  };
  EXPECT_NO_THROW(check_pcd(file(lines)));
  for (const char* name : {"bun0", "bun4", "lamppost", "milk", "spot_turntable/scan_00"})
    EXPECT_NO_THROW(check_pcd(io::read_file(std::string(TEST_DATA "/") + name + ".pcd"))) << name;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::vector<std::string> without = lines;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(k));
    if (lines[k].rfind("VIEWPOINT", 0) == 0 || lines[k].rfind("COUNT", 0) == 0) {
      EXPECT_NO_THROW(check_pcd(file(without))) << lines[k];  // these two have defaults
    } else {
      EXPECT_THROW(check_pcd(file(without)), CaptureError) << lines[k];
    }
  }
  for (const auto& [line, other] : std::vector<std::pair<std::size_t, std::string>>{
           {1, "FIELDS x y"},
           {2, "SIZE 4 4"},
           {2, "SIZE 4 4 3"},
           {3, "TYPE F F X"},
           {4, "COUNT 1 1 -1"},
           {4, "COUNT 1 1 0"},
           {5, "WIDTH 99999999999999999999"},
           {5, "WIDTH 3"},
           {7, "VIEWPOINT 0 0 0 nan 0 0 0"},
           {9, "DATA binary"},
           {9, "DATA binary_compressed"},
           {9, "DATA"},
           {10, "1 2"},
       }) {
    std::vector<std::string> changed = lines;
    changed[line] = other;
    EXPECT_THROW(check_pcd(file(changed)), CaptureError) << other;
  }
  EXPECT_THROW(check_pcd(""), CaptureError);
}

TEST(StrictPcd, TheHeaderDoesNotGoOnBehindItsData) {
  const std::string header =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 8\nHEIGHT 1\nPOINTS 8\n"
      "DATA binary\n";
  const auto file = [&](std::string body) { return header + body + std::string(96 - body.size(), '.'); };
  EXPECT_NO_THROW(check_pcd(file("# what looks like a comment\n\n is none\nCOUNT 9 9 9\n")));
  for (const char* body :
       {"COUNT 9 9 9\n", "#\nCOUNT 9 9 9\n", "\n\n \tSIZE 8 8 8\n", "#\r\n\vPOINTS 9000\n"})
    EXPECT_THROW(check_pcd(file(body)), CaptureError) << body;
}

TEST(StrictPcd, ABlankLineInTheHeaderIsRefused) {
  const auto file = [](const std::string& between) {
    return "VERSION 0.7\n" + between +
           "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 "
           "3\n";
  };
  EXPECT_NO_THROW(check_pcd(file("\n")));
  for (const char* blank : {"\r\n", " \n", "\t\n", "\n \r\n"})
    EXPECT_THROW(check_pcd(file(blank)), CaptureError);
}

TEST(OpenniSource, AFileThatIsNoRecordingIsRefused) {
  const ScratchFolder folder;
  std::ofstream(folder / "noise.oni") << "noise";
  EXPECT_THROW(openni_source(folder / "noise.oni"), CaptureError);
}

TEST(Poses, OfATrajectoryGoByTimeOrByNumber) {
  Trajectory given;
  for (int k = 0; k < 3; ++k) given.add(k, pose(k, 0, 0, 0, {1, 0, 0}));
  const auto poses = trajectory_poses(given);
  Frame frame;
  for (int k = 0; k < 3; ++k) EXPECT_EQ(poses->place(frame, {}).pose->translation().x(), k);
  EXPECT_FALSE(poses->place(frame, {}).pose);
  frame.time = 1;
  EXPECT_EQ(poses->place(frame, {}).pose->translation().x(), 1);
  frame.time = 7;
  const Placement none = poses->place(frame, {});
  EXPECT_FALSE(none.pose);
  EXPECT_NE(none.reason, "");
}

TEST(Poses, OfTheCloudsGoBeforeAFit) {
  const auto poses = sensor_poses_or(trajectory_poses(parse_trajectory("0 9 0 0 0 0 0 1\n")));
  Frame frame;
  EXPECT_EQ(poses->place(frame, {}).pose->translation().x(), 9);
  frame.sensor_pose = pose(1, 2, 3, 1, {0, 1, 0});
  EXPECT_TRUE(poses->place(frame, {}).pose->isApprox(frame.sensor_pose));
}

/// The transformation from bun0 to bun4 that the tests of PCL's own ICP expect.
Pose bun0_to_bun4() {
  Pose expected = Pose::Identity();
  expected.matrix() << 0.8806, 0.0365, -0.4724, 0.03453,  //
      -0.02354, 0.9992, 0.03326, -0.001519,               //
      0.4732, -0.01817, 0.8808, 0.04116,                  //
      0, 0, 0, 1;
  expected.linear() = Eigen::Quaterniond(expected.linear()).normalized().toRotationMatrix();
  return expected;
}

TEST(Registration, FindsTheMotionBetweenTwoRealScans) {
  for (const Fit method : {Fit::Icp, Fit::Gicp}) {
    RegistrationOptions options;
    options.fit = method;
    const auto poses = registered_poses(options);
    const auto source = pcd_sequence({kBun0, kBun4});
    const Frame first = *source->next(), second = *source->next();
    EXPECT_TRUE(poses->place(first, frame_points(first, {})).pose->isApprox(Pose::Identity()));
    const Placement found = poses->place(second, frame_points(second, {}));
    ASSERT_TRUE(found.pose) << found.reason;
    const auto [angle, shift] = difference(*found.pose, bun0_to_bun4().inverse());
    // Points are 0.004 apart, and theirs is pulled by what does not overlap, too.
    EXPECT_LT(angle, 0.15);   // of 0.49
    EXPECT_LT(shift, 0.012);  // of a scan of 0.15
  }
}

TEST(Registration, IsTheSameInEveryUnitAndFarFromTheOrigin) {
  const auto fit = [](double scale, const Eigen::Vector3d& offset) {
    const auto poses = registered_poses({});
    const auto source = pcd_sequence({kBun0, kBun4});
    Placement found;
    for (int k = 0; k < 2; ++k) {
      const Frame frame = *source->next();
      Model points = frame_points(frame, {});
      for (Point& p : points.positions)
        for (int axis = 0; axis < 3; ++axis) p[axis] = scale * p[axis] + offset[axis];
      found = poses->place(frame, points);
    }
    return found;
  };
  const Placement once = fit(1, {0, 0, 0}), larger = fit(1000, {0, 0, 0});
  ASSERT_TRUE(once.pose && larger.pose);
  const auto [angle, shift] =
      difference(*once.pose, Pose(Eigen::Translation3d(larger.pose->translation() / 1000) *
                                  Eigen::Quaterniond(larger.pose->linear())));
  EXPECT_LT(angle, 0.01);
  EXPECT_LT(shift, 0.001);
  ASSERT_TRUE(fit(1, {5e5, 4e6, 100}).pose);
}

TEST(Registration, WhatDoesNotFitIsLeftOut) {
  const auto poses = registered_poses({});
  const auto source = pcd_sequence({kBun0, TEST_DATA "/lamppost.pcd"});
  const Frame bunny = *source->next(), lamppost = *source->next();
  ASSERT_TRUE(poses->place(bunny, frame_points(bunny, {})).pose);
  const Placement none = poses->place(lamppost, frame_points(lamppost, {}));
  EXPECT_FALSE(none.pose);
  EXPECT_NE(none.reason.find("fit"), std::string::npos);
  Model few{{{0, 0, 0}, {1, 1, 1}}, {}, {}};
  EXPECT_FALSE(poses->place(lamppost, few).pose);
  Model same{std::vector<Point>(100, Point{1, 1, 1}), {}, {}};
  EXPECT_FALSE(poses->place(lamppost, same).pose);
  ASSERT_TRUE(poses->place(bunny, frame_points(bunny, {})).pose);  // it goes on
}

TEST(Accumulator, LeavesOutFramesAndSaysWhy) {
  Accumulator accumulator({}, trajectory_poses(parse_trajectory("0 0 0 0 0 0 0 1\n")));
  EXPECT_TRUE(accumulator.points().positions.empty());
  const auto source = pcd_sequence({kBun0, kBun4});
  const Frame bun0 = *source->next(), bun4 = *source->next();
  EXPECT_FALSE(accumulator.add(bun0));
  const auto fault = accumulator.add(bun4);  // its time is 4
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->find("trajectory"), std::string::npos);
  Frame empty;
  empty.cloud = bun0.cloud;
  empty.cloud.fields.clear();
  EXPECT_TRUE(accumulator.add(empty));
  EXPECT_EQ(accumulator.placed().size(), 1u);
  EXPECT_EQ(accumulator.left_out(), 2u);
  EXPECT_GT(accumulator.size(), 100u);
}

TEST(BackgroundMesher, TakesOneCloudAtATime) {
  std::mutex mutex;
  std::condition_variable changed;
  bool go_on = false;
  std::vector<std::size_t> done;
  BackgroundMesher mesher({}, {[](double, const char*) {},
                               [&](std::size_t frames, const Model& cloud, const Result& result) {
                                 std::unique_lock<std::mutex> lock(mutex);
                                 changed.wait(lock, [&] { return go_on; });
                                 EXPECT_EQ(result.status, Status::Ok);
                                 EXPECT_EQ(cloud.positions.size(), 500u);
                                 done.push_back(frames);
                               }});
  const Model cloud{test::sphere(500, 3), {}, {}};
  EXPECT_TRUE(mesher.idle());
  EXPECT_TRUE(mesher.offer(1, cloud));
  EXPECT_FALSE(mesher.idle());
  EXPECT_FALSE(mesher.offer(2, cloud));
  {
    const std::lock_guard<std::mutex> lock(mutex);
    go_on = true;
  }
  changed.notify_all();
  mesher.wait();
  EXPECT_TRUE(mesher.offer(3, cloud));
  mesher.wait();
  EXPECT_EQ(done, (std::vector<std::size_t>{1, 3}));
}

TEST(BackgroundMesher, IsCancelledAtTheEnd) {
  bool done = false;
  const auto begin = std::chrono::steady_clock::now();
  {
    BackgroundMesher mesher({}, {nullptr, [&](std::size_t, const Model&, const Result&) { done = true; }});
    mesher.offer(1, {test::sphere(100000, 4), {}, {}});
  }
  EXPECT_FALSE(done);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

}  // namespace
}  // namespace filmsticking::capture
