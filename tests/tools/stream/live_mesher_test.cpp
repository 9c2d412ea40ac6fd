// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream/live_mesher.h"

#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <string>
#include <vector>

#include "io/cloud.h"
#include "support/clouds.h"
#include "support/facing.h"
#include "support/surface_check.h"

namespace filmsticking::stream {
namespace {

using std::chrono::seconds;

const LiveMesher::Clock::time_point kStart = LiveMesher::Clock::now();

Frame frame_of(const std::vector<Point>& points, const std::vector<io::Colour>& colours = {}) {
  Frame frame;
  frame.cloud = io::make_cloud(points, colours);
  return frame;
}

Frame ball(int points, std::uint64_t seed = 1, Point centre = {0, 0, 0}) {
  return frame_of(test::sphere(points, seed, centre));
}

std::string fault_of(const LiveOutcome& outcome) {
  return test::surface_fault({io::positions_of(outcome.mesh.cloud), io::triangles_of(outcome.mesh.polygons)});
}

class LiveMesherTest : public testing::Test {
 protected:
  std::vector<LiveOutcome> published;
  LiveMesher mesher{[this](const LiveOutcome& outcome) { published.push_back(outcome); }};
  Settings settings;
};

TEST_F(LiveMesherTest, MeshesEachFrameAsItCame) {
  std::vector<Point> points = test::sphere(500, 1);
  for (Point& p : points)
    for (double& x : p) x = static_cast<float>(x);
  const Frame frame = frame_of(points, std::vector<io::Colour>(points.size(), {10, 20, 30}));
  mesher.set(settings);
  mesher.add(frame, {"map", 42}, kStart);
  const auto outcome = mesher.wait(1);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->status, Status::Ok);
  EXPECT_EQ(outcome->origin.frame_id, "map");
  EXPECT_EQ(outcome->origin.stamp, 42);
  EXPECT_EQ(fault_of(*outcome), "");
  const std::vector<Point> vertices = io::positions_of(outcome->mesh.cloud);
  EXPECT_EQ(io::colours_of(outcome->mesh.cloud), std::vector<io::Colour>(vertices.size(), {10, 20, 30}));
  const std::set<Point> known(points.begin(), points.end());
  for (const Point& p : vertices) EXPECT_TRUE(known.count(p));
  ASSERT_EQ(published.size(), 1u);
  EXPECT_EQ(io::triangles_of(published[0].mesh.polygons), io::triangles_of(outcome->mesh.polygons));
  EXPECT_EQ(mesher.last_mesh(), outcome);
}

TEST_F(LiveMesherTest, ByCount) {
  settings.every_frames = 3;
  settings.bounds.window = 0;
  mesher.set(settings);
  for (int frame = 1; frame <= 7; ++frame) {
    mesher.add(ball(60, static_cast<std::uint64_t>(frame)), {"map", frame}, kStart);
    if (frame % 3 == 0) {
      const auto outcome = mesher.wait(static_cast<LiveMesher::Ticket>(frame / 3));
      ASSERT_TRUE(outcome);
      EXPECT_EQ(outcome->points, 60 * frame);
      EXPECT_EQ(outcome->origin.stamp, frame);
    }
  }
  EXPECT_EQ(mesher.facts().meshes, 2);
  EXPECT_EQ(mesher.facts().frames, 7);
}

TEST_F(LiveMesherTest, ByTimeIfSomethingCame) {
  settings.every_frames = 0;
  settings.every_seconds = 2;
  mesher.set(settings);
  mesher.tick(kStart + seconds(100));
  mesher.add(ball(100), {}, kStart + seconds(200));
  mesher.tick(kStart + seconds(201));
  EXPECT_FALSE(mesher.facts().busy);
  mesher.tick(kStart + seconds(202));
  ASSERT_TRUE(mesher.wait(1));
  mesher.tick(kStart + seconds(300));
  EXPECT_FALSE(mesher.facts().busy);
  mesher.add(ball(100), {}, kStart + seconds(301));
  mesher.tick(kStart + seconds(301));  // the last one was long ago
  ASSERT_TRUE(mesher.wait(2));
  EXPECT_EQ(mesher.facts().meshes, 2);
}

TEST_F(LiveMesherTest, OnRequestOnly) {
  settings.every_frames = 0;
  mesher.set(settings);
  EXPECT_EQ(mesher.request(), 0u);
  mesher.add(ball(100), {}, kStart);
  EXPECT_FALSE(mesher.facts().busy);
  const LiveMesher::Ticket ticket = mesher.request();
  ASSERT_EQ(ticket, 1u);
  ASSERT_TRUE(mesher.wait(ticket));
  EXPECT_EQ(mesher.facts().held, 100);
}

TEST_F(LiveMesherTest, SaysWhyThereIsNoMeshAndKeepsTheLast) {
  mesher.set(settings);
  mesher.add(ball(100), {}, kStart);
  const auto good = mesher.wait(1);
  mesher.add(frame_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 3, 0}}), {}, kStart);
  const auto flat = mesher.wait(2);
  ASSERT_TRUE(flat);
  EXPECT_EQ(flat->status, Status::Coplanar);
  EXPECT_FALSE(flat->message.empty());
  EXPECT_EQ(mesher.last(), flat);
  EXPECT_EQ(mesher.last_mesh(), good);
}

TEST_F(LiveMesherTest, RunsTheFilters) {
  settings.filters.crop = filters::Box{{-2, -2, -2}, {2, 2, 2}};
  settings.bounds.window = 2;
  settings.every_frames = 2;
  mesher.set(settings);
  mesher.add(ball(200, 1, {5, 0, 0}), {}, kStart);
  mesher.add(ball(200, 2), {}, kStart);
  const auto outcome = mesher.wait(1);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->points, 400);
  EXPECT_EQ(outcome->report.points, 200);
}

TEST_F(LiveMesherTest, AFilterThatCannotRunIsAFailure) {
  settings.filters.voxel = 1e-300;
  mesher.set(settings);
  mesher.add(ball(200), {}, kStart);
  const auto outcome = mesher.wait(1);
  ASSERT_TRUE(outcome);
  EXPECT_NE(outcome->status, Status::Ok);
  EXPECT_FALSE(outcome->message.empty());
}

TEST_F(LiveMesherTest, ResetForgetsAllAndPublishesAnEmptyMesh) {
  mesher.set(settings);
  mesher.add(ball(20000), {"map", 1}, kStart);  // at the reset it may run or be done
  mesher.reset();
  EXPECT_EQ(mesher.facts().held, 0);
  EXPECT_EQ(mesher.request(), 0u);
  EXPECT_FALSE(mesher.wait(1));
  EXPECT_FALSE(mesher.last_mesh());
  ASSERT_FALSE(published.empty());
  EXPECT_TRUE(published.back().mesh.polygons.empty());

  mesher.add(ball(100), {"map", 2}, kStart);
  const auto outcome = mesher.wait(2);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->points, 100);
}

TEST_F(LiveMesherTest, ABurstEndsWithTheNewestAndHoldsNoMoreThanItMay) {
  settings.bounds.window = 0;
  settings.bounds.max_points = 3000;
  mesher.set(settings);
  constexpr int kFrames = 300;
  for (int frame = 1; frame <= kFrames; ++frame)
    mesher.add(ball(500, static_cast<std::uint64_t>(frame)), {"map", frame}, kStart);
  const auto outcome = mesher.wait(kFrames);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->origin.stamp, kFrames);
  EXPECT_EQ(fault_of(*outcome), "");
  const Facts facts = mesher.facts();
  EXPECT_LE(facts.held, 3000);
  EXPECT_GT(facts.given_up, 0);
  EXPECT_EQ(facts.meshes + facts.superseded, kFrames);
}

TEST_F(LiveMesherTest, TwoSidesOfAThinWallKeepTheirOwnSensors) {
  constexpr double kHalf = 0.05;  // two spacings between the sides
  settings.every_frames = 2;
  settings.bounds = {0.02, 0, 100000};
  settings.options.open_boundary = true;
  mesher.set(settings);
  test::Random random(6);
  for (const double side : {1.0, -1.0}) {
    std::vector<Point> points;
    for (int i = 0; i < 30; ++i)
      for (int j = 0; j < 30; ++j)
        points.push_back({(i + random.uniform(0, 0.5)) / 20, (j + random.uniform(0, 0.5)) / 20,
                          side * (kHalf - 2) + 0.002 * random.uniform()});
    Frame frame = frame_of(points);
    frame.sensor_pose.translation() << 0, 0, side * 2;
    mesher.add(frame, {"map", 1}, kStart);
  }
  const auto outcome = mesher.wait(1);
  ASSERT_TRUE(outcome);
  ASSERT_EQ(outcome->status, Status::Ok) << outcome->message;
  const Mesh mesh{io::positions_of(outcome->mesh.cloud), io::triangles_of(outcome->mesh.polygons)};
  EXPECT_GT(mesh.positions.size(), 1700u);
  EXPECT_GT(test::facing_share(mesh,
                               [](const Point& p) {
                                 return Point{0, 0, p[2] > 0 ? 2.0 : -2.0};
                               }),
            0.95);
}

TEST_F(LiveMesherTest, NewerDataCanEndTheRunningOne) {
  settings.cancel_outdated = true;
  mesher.set(settings);
  mesher.add(ball(100000), {"map", 1}, kStart);
  mesher.add(ball(100), {"map", 2}, kStart);
  const auto outcome = mesher.wait(2);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->origin.stamp, 2);
  EXPECT_EQ(published.size(), 1u);
}

}  // namespace
}  // namespace filmsticking::stream
