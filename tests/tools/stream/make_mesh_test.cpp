// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream/make_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <string>
#include <vector>

#include "filmsticking/reconstruct.h"
#include "io/cloud.h"
#include "support/clouds.h"
#include "support/facing.h"
#include "support/surface_check.h"

namespace filmsticking::stream {
namespace {

MeshJob job_of(const std::vector<Point>& points) { return {io::make_cloud(points), {}, {}}; }

TEST(MakeMesh, MakesAClosedMeshOfThePointsWithTheirColours) {
  std::vector<std::string> stages;
  const std::vector<Point> points = test::sphere(500, 3);
  const MeshJob job{io::make_cloud(points, std::vector<io::Colour>(points.size(), {1, 2, 3})), {}, {}};
  const Outcome outcome =
      make_mesh(job, nullptr, [&](double, const char* stage) { stages.push_back(stage); });
  ASSERT_EQ(outcome.status, Status::Ok) << outcome.message;
  const std::vector<Point> vertices = io::positions_of(outcome.mesh.cloud);
  EXPECT_EQ(test::surface_fault({vertices, io::triangles_of(outcome.mesh.polygons)}), "");
  for (const Point& p : vertices) EXPECT_NE(std::find(points.begin(), points.end(), p), points.end());
  EXPECT_EQ(io::colours_of(outcome.mesh.cloud), std::vector<io::Colour>(vertices.size(), {1, 2, 3}));
  EXPECT_EQ(outcome.points, 500);
  EXPECT_FALSE(stages.empty());
}

TEST(MakeMesh, AnOpenSurfaceFacesWhatSawItsPoints) {
  test::Random random(4);
  std::vector<Point> points;
  for (int i = 0; i < 2000; ++i)
    points.push_back({random.uniform(), random.uniform(), random.uniform(0, 0.01)});
  for (const double height : {5.0, -5.0}) {
    const Point sensor{0.5, 0.5, height};
    MeshJob job{io::with_stations(io::make_cloud(points), std::vector<Point>(points.size(), sensor)), {}, {}};
    job.options.open_boundary = true;
    const Outcome outcome = make_mesh(job);
    ASSERT_EQ(outcome.status, Status::Ok) << outcome.message;
    const Mesh mesh{io::positions_of(outcome.mesh.cloud), io::triangles_of(outcome.mesh.polygons)};
    EXPECT_GT(test::facing_share(mesh, [&](const Point&) { return sensor; }), 0.95);
    EXPECT_EQ(outcome.mesh.cloud.fields.size(), 3u);  // the sensors are not the mesh's
  }
}

TEST(MakeMesh, RunsTheFiltersFirst) {
  std::vector<Point> points = test::sphere(200, 1);
  for (const Point& p : test::sphere(200, 2, {5, 0, 0})) points.push_back(p);
  for (Point& p : points)
    for (double& x : p) x = static_cast<float>(x);
  MeshJob job = job_of(points);
  job.filters.crop = filters::Box{{-2, -2, -2}, {2, 2, 2}};
  const Outcome outcome = make_mesh(job);
  EXPECT_EQ(outcome.status, Status::Ok) << outcome.message;
  EXPECT_EQ(outcome.points, 400);
  EXPECT_EQ(outcome.report.points, 200);
}

TEST(MakeMesh, AFailureIsAStatusAndASentence) {
  const Outcome flat = make_mesh(job_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 3, 0}}));
  EXPECT_EQ(flat.status, Status::Coplanar);
  EXPECT_FALSE(flat.message.empty());
  EXPECT_TRUE(flat.mesh.polygons.empty());

  MeshJob job = job_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  job.filters.voxel = 1e-300;
  const Outcome refused = make_mesh(job);
  EXPECT_EQ(refused.status, Status::InvalidOptions);
  EXPECT_FALSE(refused.message.empty());
}

TEST(MakeMesh, TheFlagEndsItSoon) {
  const std::vector<Point> points = test::sphere(100000, 4);
  std::atomic<bool> cancel{true};  // before it begins
  EXPECT_EQ(make_mesh(job_of(points), &cancel).status, Status::Cancelled);

  cancel = false;
  std::promise<void> at_work;
  const auto begin = std::chrono::steady_clock::now();
  bool signalled = false;
  auto outcome = std::async(std::launch::async, [&] {
    return make_mesh(job_of(points), &cancel, [&](double share, const char*) {
      if (share > 0 && !signalled) at_work.set_value(), signalled = true;
    });
  });
  at_work.get_future().wait();
  cancel = true;
  const Outcome cancelled = outcome.get();
  EXPECT_EQ(cancelled.status, Status::Cancelled);
  EXPECT_TRUE(cancelled.mesh.polygons.empty());
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(MakeMesh, TriesAViewpointOnlyIfOneIsGiven) {
  // A wall that is hollow as seen from the origin, with pixels beside their places: without a viewpoint its
  // front is the other side.
  test::Random random(1);
  std::vector<Point> wall;
  for (int v = 0; v < 30; ++v)
    for (int u = 0; u < 40; ++u) {
      const double x = (u + random.uniform(-0.25, 0.25) - 19.5) / 40;
      const double y = (v + random.uniform(-0.25, 0.25) - 14.5) / 40;
      const double z = 3 - 0.3 * x * x;
      wall.push_back({x * z, y * z, z});
    }
  MeshJob job = job_of(wall);
  job.options.open_boundary = true;
  const std::vector<Triangle> without = reconstruct(wall, job.options).triangles;
  ASSERT_FALSE(without.empty());
  EXPECT_EQ(io::triangles_of(make_mesh(job).mesh.polygons), without);
  job.options.viewpoint = Point{0, 0, 0};
  EXPECT_NE(io::triangles_of(make_mesh(job).mesh.polygons), without);
}

}  // namespace
}  // namespace filmsticking::stream
