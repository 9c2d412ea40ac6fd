// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "delaunay/delaunay.h"
#include "support/cloud_setting.h"
#include "support/clouds.h"
#include "support/field_setting.h"
#include "support/surfaces.h"
#include "surface/surface_quality.h"

namespace filmsticking {
namespace {

struct Setting : test::CloudSetting {
  Pipeline pipeline;

  explicit Setting(std::vector<Point> cloud, const Options& chosen = {})
      : CloudSetting(std::move(cloud), chosen), pipeline(view, sites, geometry, options, monitor, report) {}

  FoundSurface run() { return pipeline.run(delaunay_tetrahedra(sites.perturbed)); }
  bool entered(const std::string& stage) const {
    return std::any_of(report.rooms.begin(), report.rooms.end(),
                       [&](const RoomSeconds& one) { return one.room == stage; });
  }
  double share_on(const Surface& surface) const {
    return static_cast<double>(surface.site.size()) / static_cast<double>(sites.size());
  }
};

Options open() {
  Options options;
  options.open_boundary = true;
  return options;
}

// Every vertex a site, and a manifold.
void expect_surface_of_sites(const FoundSurface& found, bool closed) {
  ASSERT_FALSE(found.surface.triangles.empty());
  const ManifoldCheck check = test::check(found.surface);
  EXPECT_TRUE(check.manifold());
  EXPECT_EQ(check.closed, closed);
  EXPECT_EQ(std::count(found.surface.site.begin(), found.surface.site.end(), kNone), 0);
}

const Point kEye{0.3, -0.2, 6};

std::vector<Point> depth_image() {
  return test::depth_view({{0, 0, 0, 0.7}, {0.5, 0.4, -0.5, 0.5}}, kEye, 0.012);
}

// A depth image of which three in ten pixels are left, with noise.
std::vector<Point> thinned_image() {
  test::Random random(5);
  std::vector<Point> points;
  for (Point p : test::depth_view({{0, 0, 0, 0.7}, {0.5, 0.4, -0.5, 0.5}}, kEye, 0.006)) {
    if (random.uniform(0, 1) > 0.3) continue;
    for (double& x : p) x += 0.01 * random.uniform(-1, 1);
    points.push_back(p);
  }
  return points;
}

TEST(Pipeline, AClosedSphereIsAcceptedAtTheFirstCut) {
  for (const bool may_be_open : {false, true}) {
    Options options;
    options.open_boundary = may_be_open;
    Setting sphere(test::sphere(2000, 1), options);
    const FoundSurface found = sphere.run();
    expect_surface_of_sites(found, true);
    EXPECT_EQ(sphere.share_on(found.surface), 1);
    EXPECT_FALSE(found.viewpoint);
    for (const char* stage : {"two sides", "carving", "gaps", "first surface"})
      EXPECT_FALSE(sphere.entered(stage)) << stage;
  }
}

TEST(Pipeline, AThinPlateIsCarvedAndStaysClosed) {
  for (const double thickness : {0.02, 0.05})
    for (const bool may_be_open : {false, true}) {
      Options options;
      options.open_boundary = may_be_open;
      Setting plate(test::box(2000, 3, {1, 1, thickness}), options);
      const FoundSurface found = plate.run();
      expect_surface_of_sites(found, true);
      EXPECT_TRUE(plate.entered("two sides"));
      EXPECT_TRUE(plate.entered("carving"));
      EXPECT_GE(plate.share_on(found.surface), 0.99);
    }
}

TEST(Pipeline, APlateThinnerThanItsSpacingIsASheetByItsTwoSides) {
  Setting plate(test::box(2000, 3, {1, 1, 0.005}), open());
  const FoundSurface found = plate.run();
  expect_surface_of_sites(found, false);
  EXPECT_TRUE(plate.entered("two sides"));
  EXPECT_GE(plate.share_on(found.surface), 0.99);
}

TEST(Pipeline, ACapHasABoundaryOnlyIfItMay) {
  std::vector<Point> cap;
  for (const Point& p : test::sphere(3000, 8))
    if (p[2] > 0.2) cap.push_back(p);
  Setting may(cap, open()), must_not(cap);
  const FoundSurface disc = may.run(), lid = must_not.run();
  expect_surface_of_sites(disc, false);
  EXPECT_EQ(boundary_loops(test::twins_of(disc.surface)), 1);
  expect_surface_of_sites(lid, true);
  EXPECT_EQ(lid.surface.site, disc.surface.site);
}

TEST(Pipeline, ADepthImageIsSeenWithoutTetrahedra) {
  Setting image(depth_image(), open());
  const auto seen = image.pipeline.visible_surface();
  ASSERT_TRUE(seen);
  expect_surface_of_sites(*seen, false);
  ASSERT_TRUE(seen->viewpoint);
  const Point eye = image.sites.to_input(*seen->viewpoint);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(eye[k], kEye[k], 0.5);
  for (Index t = 0; t < static_cast<Index>(seen->surface.triangles.size()); ++t)
    EXPECT_GT(seen->surface.area_vector2(t).dot(*seen->viewpoint - seen->surface.corner(t, 0)), 0);
  EXPECT_EQ(image.report.tetrahedra, 0);
}

TEST(Pipeline, WhatIsNoDepthImageIsNotSeen) {
  for (const auto& points : {test::sphere(2000, 1), test::torus(2000, 2), thinned_image()})
    EXPECT_FALSE(Setting(points, open()).pipeline.visible_surface());
}

TEST(Pipeline, BehindADepthImageIsTheInside) {
  Setting image(depth_image());
  const FoundSurface found = image.run();
  expect_surface_of_sites(found, true);
  EXPECT_TRUE(image.entered("depth image"));
  EXPECT_FALSE(image.entered("two sides"));
  EXPECT_EQ(image.share_on(found.surface), 1);
}

TEST(Pipeline, AGivenViewpointDecidesWhereThePointsDoNotRevealIt) {
  Options with = open();
  with.viewpoint = kEye;
  Setting image(thinned_image(), with);
  const auto found = image.pipeline.visible_surface();
  ASSERT_TRUE(found);
  expect_surface_of_sites(*found, false);
  ASSERT_TRUE(found->viewpoint);
  for (Index t = 0; t < static_cast<Index>(found->surface.triangles.size()); ++t)
    EXPECT_GT(found->surface.area_vector2(t).dot(*found->viewpoint - found->surface.corner(t, 0)), 0);
}

TEST(Pipeline, AGivenViewpointChangesNothingOfAClosedSphere) {
  Options with = open();
  with.viewpoint = Point{0, 0, 3};
  const FoundSurface one = Setting(test::sphere(2000, 1), with).run(),
                     other = Setting(test::sphere(2000, 1), open()).run();
  EXPECT_EQ(one.surface.triangles, other.surface.triangles);
  EXPECT_FALSE(one.viewpoint);
}

// Nothing that is slow is tried where nothing can be decided.
TEST(Pipeline, WithoutAnInsideTheLeastEnergyIsTaken) {
  for (const std::uint64_t seed : {16, 18, 28}) {
    Setting scattered(test::awkward(seed));
    const FoundSurface found = scattered.run();
    expect_surface_of_sites(found, true);
    EXPECT_TRUE(scattered.entered("carving"));
    EXPECT_FALSE(scattered.entered("first surface"));
  }
}

TEST(Pipeline, AFilmStartsFromTheSurfaceThatIsAskedFor) {
  for (const FilmStart start : {FilmStart::Sphere, FilmStart::Wrap, FilmStart::Given}) {
    Options options;
    options.method = Method::Film;
    options.film_start = start;
    options.max_steps = 10;
    options.max_rounds = 1;
    const Surface ball = test::ball();
    Mesh given;
    for (const Point& p : test::places_of(ball)) given.positions.push_back({9 * p[0], 9 * p[1], 9 * p[2]});
    given.triangles.assign(ball.triangles.begin(), ball.triangles.end());
    options.guiding_surface = std::make_shared<Mesh>(given);
    Setting torus(test::torus(600, 1), options);
    std::vector<Mesh> shown;
    torus.execution.on_step = [&](int, const Mesh& mesh) { shown.push_back(mesh); };
    const FoundSurface found = torus.run();
    expect_surface_of_sites(found, true);
    EXPECT_FALSE(torus.report.steps.empty());
    EXPECT_FALSE(torus.entered("signed field"));
    ASSERT_FALSE(shown.empty());
    const bool is_given = shown.front().triangles == given.triangles &&
                          std::abs(shown.front().positions[0][1] - given.positions[0][1]) < 1e-9;
    EXPECT_EQ(is_given, start == FilmStart::Given);
  }
}

TEST(Pipeline, TheLastResortEnclosesTheLargestTetrahedron) {
  Setting flat(test::awkward(59));
  flat.run();
  const Surface around = flat.pipeline.around_one_tetrahedron();
  EXPECT_TRUE(test::check(around).ok());
  EXPECT_GE(around.site.size(), 4U);
  EXPECT_GT(std::abs(test::signed_volume6(around)), 0);
}

// The walls of a room, with corners, seen from one place: no second skin, no shell; its air is the inside.
TEST(Pipeline, ARoomSeenFromInsideIsItsAir) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    std::vector<Point> walls;
    double top = -INFINITY, bottom = INFINITY, left = INFINITY, front = INFINITY;
    const std::vector<Point> all = test::box(6000, seed, {6, 4, 2.8});
    for (const Point& p : all) {
      top = std::max(top, p[2]), bottom = std::min(bottom, p[2]);
      left = std::min(left, p[0]), front = std::min(front, p[1]);
    }
    for (const Point& p : all)  // a part of the ceiling is missing
      if (p[2] < top - 1e-6 || p[0] < left + 4) walls.push_back(p);
    Options options;
    options.viewpoint = Point{left + 2.6, front + 1.7, (top + bottom) / 2};
    Setting room(walls, options);
    const FoundSurface found = room.run();
    expect_surface_of_sites(found, true);
    EXPECT_GT(room.share_on(found.surface), 0.99);
    const double volume = std::abs(test::signed_volume6(found.surface)) / 6;
    EXPECT_NEAR(volume, 6 * 4 * 2.8 / (6.0 * 6 * 6), 0.05 * 6 * 4 * 2.8 / (6.0 * 6 * 6));
  }
}

// A height field of hills: closed, its base is behind it as seen from above.
TEST(Pipeline, AHeightFieldHasItsBaseBehindIt) {
  for (const double side : {-1.0, 1.0}) {
    SCOPED_TRACE(side);
    test::Random random(1);
    std::vector<Point> hills;
    for (int i = 0; i < 4000; ++i) {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      hills.push_back({x, y, side * 0.4 * std::exp(-6 * (x * x + y * y))});
    }
    Options options;
    options.view_direction = Point{0, 0, -side};
    Setting setting(hills, options);
    const FoundSurface found = setting.run();
    expect_surface_of_sites(found, true);
    EXPECT_GT(setting.share_on(found.surface), 0.99);
    // The hill's volume, 0.4 pi / 6, in the unit of the sites.
    EXPECT_NEAR(std::abs(test::signed_volume6(found.surface)) / 6, 0.4 * M_PI / 6 / 8,
                0.1 * 0.4 * M_PI / 6 / 8);
  }
}

// As PCD's VIEWPOINT does where somebody has moved the points.
TEST(Pipeline, AWrongViewpointOfAClosedCloudChangesNothing) {
  for (const auto& cloud : {test::torus(3000, 4), test::box(3000, 5, {1, 1, 0.3})}) {
    const FoundSurface without = Setting(cloud).run();
    for (const Point& wrong : {Point{9, 2, 3}, Point{-40, 70, 1}, Point{0.9, 0.1, 0.1}})
      for (const bool trusted : {false, true}) {
        if (trusted && wrong[0] == 0.9) continue;  // a sensor inside may be in a room
        Options options;
        options.viewpoint = wrong;
        options.trust_viewpoint = trusted;
        EXPECT_EQ(Setting(cloud, options).run().surface.triangles, without.surface.triangles)
            << wrong[0] << " " << trusted;
      }
  }
}

// The surface of a cavity was one of its own where the neck of a bottle, four spacings wide, was barred.
TEST(Pipeline, Regression_AMouthIsNotBarred) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    Setting bottle(test::ball_with_cavity(seed, 0.6, 0.16));
    EXPECT_EQ(surface_quality(bottle.run().surface, bottle.geometry).complexity, 1);
  }
}

}  // namespace
}  // namespace filmsticking
