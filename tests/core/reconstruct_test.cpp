// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of reconstruct(), by number, over generated and real clouds.
#include "filmsticking/reconstruct.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "support/clouds.h"
#include "support/surface_check.h"

namespace filmsticking {
namespace {

Mesh mesh_of(const Result& result, const std::vector<Point>& points) {
  Mesh mesh;
  for (std::int32_t i : result.vertices) mesh.positions.push_back(points.at(i));
  mesh.triangles = result.triangles;
  return mesh;
}

// Guarantees 1 to 4 and 6, whatever the input.
void expect_promise(const Result& result, const std::vector<Point>& points) {
  if (result.status != Status::Ok) {
    EXPECT_TRUE(result.triangles.empty() && result.vertices.empty());
    EXPECT_FALSE(result.message.empty());
    return;
  }
  EXPECT_TRUE(result.message.empty());
  EXPECT_TRUE(std::is_sorted(result.vertices.begin(), result.vertices.end()));
  const Mesh mesh = mesh_of(result, points);
  EXPECT_EQ(test::surface_fault(mesh), "");
  EXPECT_TRUE(result.report.closed && result.report.manifold);
  EXPECT_EQ(result.report.interpolated, static_cast<std::int64_t>(mesh.positions.size()));
}

std::map<std::string, std::vector<Point>> clouds() {
  auto two = test::sphere(1500, 3);
  for (const Point& p : test::sphere(1500, 4, {3, 0, 0})) two.push_back(p);
  return {{"sphere", test::sphere(2000, 1)},
          {"torus", test::torus(3000, 2)},
          {"two spheres", two},
          {"cube", test::box(3000, 5, {1, 1, 1})},
          {"thin plate", test::box(3000, 6, {1, 1, 0.02})},
          {"grid", test::grid(9)},
          {"bun0", test::read_text_pcd(TEST_DATA "/bun0.pcd")},
          {"spot", test::read_float_ply(TEST_DATA "/spot_10k.ply")}};
}

Options options_of(InitialSurface first, FieldMethod field) {
  Options options;
  options.initial_surface = first;
  options.field = field;
  options.max_steps = 20;
  options.max_rounds = 2;
  return options;
}

TEST(Reconstruct, Guarantee1to4_EveryWayOnEveryCloud) {
  for (const auto& [name, points] : clouds())
    for (const InitialSurface first : {InitialSurface::Carve, InitialSurface::Wrap, InitialSurface::Sphere})
      for (const FieldMethod field : {FieldMethod::Sculpt, FieldMethod::None, FieldMethod::Poisson}) {
        SCOPED_TRACE(name + " " + std::to_string(int(first)) + " " + std::to_string(int(field)));
        ASSERT_GT(points.size(), 300u);
        const Result result = reconstruct(points, options_of(first, field));
        EXPECT_EQ(result.status, Status::Ok) << result.message;
        expect_promise(result, points);
        if (result.report.components == 1) {
          EXPECT_GT(test::signed_volume(mesh_of(result, points)), 0);
        }
      }
}

TEST(Reconstruct, Guarantee1to6_OnAwkwardClouds) {
  int made = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    SCOPED_TRACE(seed);
    const auto points = test::awkward(seed);
    const Result result = reconstruct(points);
    EXPECT_NE(result.status, Status::InternalError) << result.message;
    expect_promise(result, points);
    made += result.status == Status::Ok;
  }
  EXPECT_GT(made, 500);
}

TEST(Reconstruct, Guarantee5_SameBytesForAnyThreadsAndOrder) {
  for (const auto& [name, points] : clouds()) {
    SCOPED_TRACE(name);
    Options options;
    options.threads = 1;
    const Result one = reconstruct(points, options);
    for (const int threads : {2, 8, 0}) {
      options.threads = threads;
      const Result other = reconstruct(points, options);
      EXPECT_EQ(one.vertices, other.vertices);
      EXPECT_EQ(one.triangles, other.triangles);
    }
    auto reversed = points;
    std::reverse(reversed.begin(), reversed.end());
    const Result back = reconstruct(reversed);
    EXPECT_EQ(back.report.genus, one.report.genus);
    std::vector<Point> a = mesh_of(one, points).positions, b = mesh_of(back, reversed).positions;
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    EXPECT_EQ(a, b);
  }
}

bool cuts_itself(const Mesh& mesh) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Surface_mesh<Kernel::Point_3> surface;
  using Vertex = CGAL::Surface_mesh<Kernel::Point_3>::Vertex_index;
  for (const Point& p : mesh.positions) surface.add_vertex({p[0], p[1], p[2]});
  for (const Triangle& t : mesh.triangles)
    surface.add_face(Vertex(static_cast<unsigned>(t[0])), Vertex(static_cast<unsigned>(t[1])),
                     Vertex(static_cast<unsigned>(t[2])));
  return CGAL::Polygon_mesh_processing::does_self_intersect(surface);
}

// Thin plates down to a twentieth of the spacing and points anywhere in a box: where a carved surface comes
// out (no film steps were needed), it is part of a triangulation.
TEST(Reconstruct, ACarvedSurfaceNeverCutsItself) {
  int carved = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    test::Random random(seed);
    std::vector<Point> scatter(400);
    for (Point& p : scatter)
      for (double& x : p) x = random.uniform();
    std::vector<std::vector<Point>> all = {test::torus(1500, seed), scatter};
    for (const double thickness : {0.05, 0.02, 0.002})
      all.push_back(test::box(1500, seed, {1, 1, thickness}));
    for (const auto& points : all) {
      // A turned plate: on the axes its points are on common planes, where flat tetrahedra have no inside.
      std::vector<Point> turned = points;
      for (Point& p : turned)
        p = {0.6 * p[0] - 0.8 * p[2] + random.uniform() * 1e-4, p[1] + random.uniform() * 1e-4,
             0.8 * p[0] + 0.6 * p[2] + random.uniform() * 1e-4};
      const Result result = reconstruct(turned);
      if (result.status != Status::Ok || !result.report.steps.empty()) continue;
      ++carved;
      EXPECT_FALSE(cuts_itself(mesh_of(result, turned))) << "seed " << seed;
    }
  }
  EXPECT_GT(carved, 40);
}

// Its sides are flat: tetrahedra of their points have no inside.
TEST(Reconstruct, Regression_FlatSidesDoNotFoldOver) {
  for (const auto& [seed, thickness] : {std::pair(54, 1), std::pair(50, 3)}) {  // in spacings
    const auto points =
        test::box(1500, static_cast<std::uint64_t>(seed), {1, 1, thickness * std::sqrt(2.0 / 1500)});
    const Result result = reconstruct(points);
    ASSERT_EQ(result.status, Status::Ok);
    EXPECT_FALSE(cuts_itself(mesh_of(result, points))) << seed;
  }
}

// One side of the wall has a large gap, half of which samples of the other fill.
TEST(Reconstruct, Regression_ThinPlatesHaveNoTunnelAFacetWide) {
  for (const std::uint64_t seed : {52, 60}) {
    const auto points = test::box(4000, seed, {1, 1, 0.5 * std::sqrt(2.0 / 4000)});
    const Result result = reconstruct(points);
    ASSERT_EQ(result.status, Status::Ok);
    EXPECT_EQ(result.report.genus, 0) << seed;
    EXPECT_EQ(result.report.components, 1) << seed;
  }
}

// One component without handles, and no fewer points on it.
void expect_one_ball(const Result& result, std::int64_t interpolated, std::uint64_t seed) {
  ASSERT_EQ(result.status, Status::Ok);
  EXPECT_EQ(result.report.genus, 0) << seed;
  EXPECT_EQ(result.report.components, 1) << seed;
  EXPECT_GE(result.report.interpolated, interpolated) << seed;
}

// Between hills it is half a spacing thick, where a weak belief gives it up.
TEST(Reconstruct, Regression_AThinReliefIsNotTornInItsValleys) {
  for (const std::uint64_t seed : {0, 15, 16, 17, 21, 24}) {
    const auto points = test::relief(2000, seed, 0.5 * std::sqrt(2.2 / 2000));
    const Result result = reconstruct(points);
    expect_one_ball(result, 1998, seed);
  }
}

// The wider a gap in both of its sides is, the more samples show that it is one.
TEST(Reconstruct, Regression_AWideGapIsNoTunnel) {
  for (const std::uint64_t seed : {55, 96}) {
    const Result result = reconstruct(test::relief(2000, seed, 0.5 * std::sqrt(2.2 / 2000)));
    expect_one_ball(result, 2000, seed);
  }
}

// Its first cut keeps nearly all sites.
TEST(Reconstruct, Regression_AWallThatIsNotThinHasNoTunnelsEither) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Result result = reconstruct(test::relief(2000, seed, 1.5 * std::sqrt(2.2 / 2000)));
    expect_one_ball(result, 2000, seed);
  }
}

// It was taken for the two sides of an open surface, with handles; and with open_boundary, with holes.
TEST(Reconstruct, Regression_AThinPlateIsNoOpenSurface) {
  for (const std::uint64_t seed : {10, 12, 14})
    for (const bool open : {false, true}) {
      Options options;
      options.open_boundary = open;
      const Result result = reconstruct(test::box(2000, seed, {1, 1, 1.5 * std::sqrt(2.0 / 2000)}), options);
      expect_one_ball(result, 1998, seed);
      EXPECT_EQ(result.report.boundary_edges, 0) << seed;
    }
}

// A rod along x, so many spacings thick, through y = `beside` of them, in noise of half of one.
void add_noisy_rod(std::vector<Point>& points, int n, double thickness, double beside, std::uint64_t seed) {
  const double length = 2, spacing = 2 * M_PI * thickness * length / n, radius = thickness * spacing;
  test::Random random(seed);
  for (int i = 0; i < n; ++i) {
    const double along = random.uniform(0, length), around = random.uniform(0, 2 * M_PI);
    points.push_back({along, beside * spacing + radius * std::cos(around), radius * std::sin(around)});
    for (double& x : points.back())  // a sum of three has the variance 1
      x += spacing / 2 * (random.uniform(-1, 1) + random.uniform(-1, 1) + random.uniform(-1, 1));
  }
}

// A ball with six limbs, so thin that noise tore them into several pieces.
TEST(Reconstruct, Regression_NoiseDoesNotTearThinLimbs) {
  const double spacing = std::sqrt(4 * M_PI / 2000), radius = 1.6 * spacing, length = 3;
  const auto limb = static_cast<int>(2 * M_PI * radius * length / (spacing * spacing));
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    test::Random random(seed);
    std::vector<Point> points;
    for (const Point& p : test::sphere(2000, seed)) {
      const double x = p[0] * p[0], y = p[1] * p[1], z = p[2] * p[2];
      if (1 - std::max({x, y, z}) > radius * radius) points.push_back(p);  // no limb starts here
    }
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1})
        for (int i = 0; i < limb; ++i) {
          Point p;
          const double around = random.uniform(0, 2 * M_PI);
          p[axis] = side * random.uniform(std::sqrt(1 - radius * radius), 1 + length);
          p[(axis + 1) % 3] = radius * std::cos(around);
          p[(axis + 2) % 3] = radius * std::sin(around);
          points.push_back(p);
        }
    for (Point& p : points)
      for (double& x : p)  // a sum of three has the variance 1
        x += spacing / 2 * (random.uniform(-1, 1) + random.uniform(-1, 1) + random.uniform(-1, 1));
    const Result result = reconstruct(points);
    ASSERT_EQ(result.status, Status::Ok);
    EXPECT_EQ(result.report.components, 1) << seed;
    EXPECT_LE(result.report.genus, 1) << seed;
  }
}

TEST(Reconstruct, NoiseDoesNotJoinPartsThatAreNear) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    std::vector<Point> points;
    add_noisy_rod(points, 2000, 3, 0, seed);
    add_noisy_rod(points, 2000, 3, 10, seed + 100);
    const Result result = reconstruct(points);
    ASSERT_EQ(result.status, Status::Ok);
    EXPECT_EQ(result.report.components, 2) << seed;
  }
}

TEST(Reconstruct, FindsTheTopology) {
  struct Case {
    const char* name;
    std::int64_t genus, components;
  };
  auto all = clouds();
  for (const Case& c : {Case{"sphere", 0, 1}, Case{"torus", 1, 1}, Case{"two spheres", 0, 2},
                        Case{"cube", 0, 1}, Case{"spot", 0, 1}}) {
    const Result result = reconstruct(all[c.name]);
    EXPECT_EQ(result.report.genus, c.genus) << c.name;
    EXPECT_EQ(result.report.components, c.components) << c.name;
    EXPECT_GE(result.report.interpolated, result.report.sites * 999 / 1000) << c.name;
  }
}

// Of a bottle with a wall of 0.08 and a mouth of 0.22: up outside, down inside.
const std::vector<std::array<double, 2>> kBottle = {{0, -1},       {0.6, -1},   {0.6, 0.3},   {0.19, 0.7},
                                                    {0.19, 1.4},   {0.11, 1.4}, {0.11, 0.65}, {0.52, 0.25},
                                                    {0.52, -0.92}, {0, -0.92}};

// A wall of a spacing. The second cut is right but for chance gaps, and was refused for these. A few of
// them stay: 7 of these ten bottles have no handle.
TEST(Reconstruct, Regression_ChanceGapsAreNoReasonAgainstASurface) {
  int balls = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Result result = reconstruct(test::revolved(3000, seed, kBottle));
    ASSERT_EQ(result.status, Status::Ok);
    EXPECT_EQ(result.report.components, 1) << seed;
    EXPECT_LE(result.report.genus, 2) << seed;
    EXPECT_GE(result.report.interpolated, 2985) << seed;
    balls += result.report.genus == 0;
  }
  EXPECT_GE(balls, 6);
}

// Walls of less than two spacings, and a mouth of five: normals fitted to neighbourhoods are of both sides
// there, and the surface was cut wrong by them, with handles or without the cavity.
TEST(Reconstruct, Regression_ABottleWithThinWallsIsOpen) {
  double glass = 0;
  for (std::size_t i = 1; i < kBottle.size(); ++i) {
    const auto &a = kBottle[i - 1], &b = kBottle[i];
    glass += M_PI / 3 * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) * (b[1] - a[1]);
  }
  int right = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const auto points = test::revolved(8000, seed, kBottle);
    const Result result = reconstruct(points);
    EXPECT_NEAR(test::signed_volume(mesh_of(result, points)) / 6, glass, 0.05 * glass) << seed;
    EXPECT_GE(result.report.interpolated, result.report.sites * 999 / 1000) << seed;
    right += result.report.genus == 0 && result.report.components == 1;
  }
  EXPECT_GE(right, 3);  // of the others the necks are tight for their gaps
}

// A scanned object on a table. The lid lay a fifth of the height inside, and the rim was frayed.
TEST(Reconstruct, Regression_TheLidOfABoxWithoutABottomIsFlat) {
  for (const double noise : {0.0, 0.0015})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      std::vector<Point> points;
      for (const Point& p : test::box(7000, seed, {0.4, 0.3, 0.25}))
        if (p[2] > 0) points.push_back(p);
      ASSERT_LT(points.size(), 6000U);
      test::Random random(seed + 100);
      for (Point& p : points)
        for (double& x : p) x += noise * random.uniform(-1, 1);
      const Result result = reconstruct(points);
      ASSERT_EQ(result.status, Status::Ok);
      EXPECT_EQ(result.report.genus, 0);
      EXPECT_EQ(result.report.components, 1);
      EXPECT_NEAR(test::signed_volume(mesh_of(result, points)) / 6, 0.03, 0.0012) << noise << " " << seed;
      EXPECT_GE(result.report.interpolated, result.report.sites * 995 / 1000);
    }
}

// Slices of a scan, four to twelve times as far apart as their points. Normals were those of the slices, and
// the solid was torn into shards.
TEST(Reconstruct, Regression_SlicesFarApartAreASolid) {
  for (const int apart : {4, 8, 12}) {
    const double step = 2 * M_PI / 150, height = 1.9 / std::round(1.9 / (apart * step));
    std::vector<Point> points;
    double volume = 0;
    for (double z = -0.95; z < 0.951; z += height) {
      const double radius = std::sqrt(1 - z * z);
      const int n = static_cast<int>(2 * M_PI * radius / step);
      for (int i = 0; i < n; ++i)
        points.push_back({1.5 * radius * std::cos(2 * M_PI * i / n), radius * std::sin(2 * M_PI * i / n), z});
      volume += 1.5 * M_PI * radius * radius * height;
    }
    const Result result = reconstruct(points);
    ASSERT_EQ(result.status, Status::Ok);
    EXPECT_EQ(result.report.genus, 0) << apart;
    EXPECT_EQ(result.report.components, 1) << apart;
    EXPECT_NEAR(test::signed_volume(mesh_of(result, points)) / 6, volume, 0.1 * volume) << apart;
    EXPECT_GE(result.report.interpolated, result.report.sites * 95 / 100) << apart;
  }
}

TEST(Reconstruct, Regression_AHandfulOfThePointsIsNoSurface) {
  std::vector<Point> points;  // sections of a wing, fifty times denser along them
  for (int section = 0; section < 15; ++section)
    for (int i = 0; i < 80; ++i) {
      const double angle = 2 * M_PI * i / 80;
      points.push_back({std::cos(angle), 4.0 * section, 0.12 * std::sin(angle)});
    }
  const Result result = reconstruct(points);
  const std::int64_t half = result.report.sites / 2;
  EXPECT_TRUE(result.status == Status::NoSurface || result.report.interpolated >= half);
  EXPECT_EQ(result.status == Status::Ok, !result.triangles.empty());
  EXPECT_EQ(result.status == Status::Ok, result.message.empty());
}

TEST(Reconstruct, PointsThatFillAVolumeAreMeshedWithAWarning) {
  const Result nodes = reconstruct(test::grid(10)), surface = reconstruct(test::sphere(1000, 1));
  EXPECT_EQ(nodes.status, Status::Ok);
  EXPECT_NE(nodes.report.warning.find("volume"), std::string::npos);
  EXPECT_EQ(surface.report.warning, "");
}

// Noise gives a shell two skins of samples. Torn into a double wall, these shapes had a tenth of their volume
// and tens of handles; a lid over the opening has half the area.
TEST(Reconstruct, Regression_ANoisySolidWithAnOpeningGetsALid) {
  struct Shape {
    const char* name;
    std::vector<std::array<double, 2>> profile;
  };
  const Shape shapes[] = {{"cup", {{0, -1}, {1, -1}, {1, 0.6}}},
                          {"tube", {{0.7, -1.4}, {0.7, 1.4}}},
                          {"dome", {{0.87, -0.5}, {1, 0}, {0.87, 0.5}, {0.5, 0.87}, {0, 1}}}};
  for (const Shape& shape : shapes) {
    double volume = 0, area = 0;
    for (std::size_t i = 1; i < shape.profile.size(); ++i) {
      const auto &a = shape.profile[i - 1], &b = shape.profile[i];
      volume += M_PI / 3 * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) * (b[1] - a[1]);
      area += M_PI * (a[0] + b[0]) * std::hypot(b[0] - a[0], b[1] - a[1]);
    }
    int right = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      auto points = test::revolved(4000, seed, shape.profile);
      const double noise = 0.18 * std::sqrt(area / 4000);
      test::Random random(seed + 100);
      for (Point& p : points)
        for (double& x : p)  // variance of a sum of three
          x += noise * (random.uniform(-1, 1) + random.uniform(-1, 1) + random.uniform(-1, 1));
      const Result result = reconstruct(points);
      const double got = test::signed_volume(mesh_of(result, points)) / 6;
      right += result.report.genus == 0 && result.report.components == 1 && got > 0.8 * std::abs(volume) &&
               got < 1.1 * std::abs(volume);
    }
    EXPECT_GE(right, 4) << shape.name;
  }
}

// A value that stands for "no return" is one outlier, and the rest is as without it.
TEST(Reconstruct, Regression_OneHugeValueIsOneOutlier) {
  const auto points = test::ellipsoid(600, 3, 10);
  const Result alone = reconstruct(points);
  for (const double huge :
       {1e6, 1e10, 1e30, double{std::numeric_limits<float>::max()}, -std::numeric_limits<double>::max()}) {
    auto with = points;
    with.push_back({huge, huge, huge});
    with.push_back({1, huge, 2});
    with.push_back({1, huge, 2});
    const Result result = reconstruct(with);
    ASSERT_EQ(result.status, Status::Ok) << huge << ": " << result.message;
    EXPECT_EQ(result.report.outliers, 2) << huge;
    EXPECT_EQ(result.report.sites, 602) << huge;
    EXPECT_EQ(result.report.duplicates, 1) << huge;
    EXPECT_EQ(result.vertices, alone.vertices) << huge;
    EXPECT_EQ(result.triangles, alone.triangles) << huge;
    Options keep;
    keep.keep_outliers = true;
    EXPECT_EQ(reconstruct(with, keep).report.outliers, 0) << huge;
  }
  // A plane and one point far from it: nothing else encloses a volume, and hardly a point is on what does.
  std::vector<Point> tent;
  for (int i = 0; i < 100; ++i) tent.push_back({double(i % 10), double(i / 10), 0});
  tent.push_back({5, 5, 1e6});
  const Result result = reconstruct(tent);
  EXPECT_EQ(result.status, Status::NoSurface);
  EXPECT_NE(result.message.find("of 101 points"), std::string::npos) << result.message;
  EXPECT_EQ(result.report.outliers, 0);
}

TEST(Reconstruct, ACavityIsACutOutOfTheVolume) {
  auto points = test::sphere(4000, 7);
  for (const Point& p : test::sphere(1000, 8, {0, 0, 0}, 0.5)) points.push_back(p);
  const Result result = reconstruct(points);
  EXPECT_EQ(result.report.components, 2);
  EXPECT_EQ(result.report.genus, 0);
  const double ball = 4 * M_PI / 3;
  EXPECT_NEAR(test::signed_volume(mesh_of(result, points)) / 6, ball * (1 - 0.125), 0.02 * ball);
}

TEST(Reconstruct, VolumeComesNearTheTruth) {
  const auto points = test::torus(5000, 9);
  const double truth = 2 * M_PI * M_PI * 0.4 * 0.4;
  EXPECT_NEAR(test::signed_volume(mesh_of(reconstruct(points), points)) / 6, truth, 0.02 * truth);
}

TEST(Reconstruct, RefusesWhatEnclosesNothing) {
  EXPECT_EQ(reconstruct({}).status, Status::TooFewPoints);
  EXPECT_EQ(reconstruct({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).status, Status::TooFewPoints);
  EXPECT_EQ(reconstruct(std::vector<Point>(50, {1, 2, 3})).status, Status::TooFewPoints);
  std::vector<Point> line, plane;
  for (int i = 0; i < 30; ++i) {
    line.push_back({0.1 * i, 0.2 * i, 0.3 * i});
    plane.push_back({float(i % 6), float(i / 6), float(i % 6) * 0.3f + float(i / 6) * 0.7f});
  }
  EXPECT_EQ(reconstruct(line).status, Status::Coplanar);
  EXPECT_EQ(reconstruct(plane).status, Status::Coplanar);
}

TEST(Reconstruct, FourPointsMakeATetrahedron) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Result result = reconstruct(points);
  EXPECT_EQ(result.status, Status::Ok);
  expect_promise(result, points);
  EXPECT_EQ(result.triangles.size(), 4u);
}

TEST(Reconstruct, RefusesWrongOptions) {
  const auto points = test::sphere(100, 10);
  for (int wrong = 0; wrong < 4; ++wrong) {
    Options options;
    if (wrong == 0) options.max_steps = 0;
    if (wrong == 1) options.max_rounds = -1;
    if (wrong == 2) options.threads = -1;
    if (wrong == 3) options.virtual_sites = -2;
    const Result result = reconstruct(points, options);
    EXPECT_EQ(result.status, Status::InvalidOptions);
    EXPECT_FALSE(result.message.empty());
  }
}

TEST(Reconstruct, TakesAGivenSurfaceAndRefusesAnOpenOne) {
  const auto points = test::torus(2000, 11);
  const Result first = reconstruct(points);
  auto given = std::make_shared<Mesh>(mesh_of(first, points));
  Options options;
  options.method = Method::Film;
  options.film_start = FilmStart::Given;
  EXPECT_EQ(reconstruct(points, options).status, Status::InvalidGuidingSurface);  // none
  options.guiding_surface = given;
  const Result again = reconstruct(points, options);
  EXPECT_EQ(again.status, Status::Ok);
  EXPECT_EQ(again.report.genus, 1);
  given->triangles.pop_back();
  EXPECT_EQ(reconstruct(points, options).status, Status::InvalidGuidingSurface);
  given->triangles.clear();
  EXPECT_EQ(reconstruct(points, options).status, Status::InvalidGuidingSurface);
}

TEST(Reconstruct, PaperPresetRunsThePapersPipeline) {
  const auto points = test::read_float_ply(TEST_DATA "/spot_10k.ply");
  const Result result = reconstruct(points, Options::paper());
  expect_promise(result, points);
  EXPECT_EQ(result.status, Status::Ok);
  EXPECT_EQ(result.report.rounds, 1);
  EXPECT_EQ(result.report.inserted, 0);
}

TEST(Reconstruct, ProgressRisesAndCancelStops) {
  const auto points = test::torus(3000, 12);
  for (int stop_at = 0; stop_at < 12; ++stop_at) {
    std::atomic<bool> cancel{false};
    int calls = 0;
    double last = 0;
    Execution execution;
    execution.cancel = &cancel;
    execution.progress = [&](double share, const char* stage) {
      EXPECT_GE(share, last);
      EXPECT_LE(share, 1);
      EXPECT_NE(stage, nullptr);
      last = share;
      if (++calls > stop_at) cancel = true;
    };
    const Result result = reconstruct(points, {}, execution);
    if (last < 1) {
      EXPECT_EQ(result.status, Status::Cancelled);
    }
    expect_promise(result, points);
  }
}

TEST(Reconstruct, StepsAreRecordedAndShown) {
  const auto points = test::sphere(2000, 13);
  Options options;
  options.method = Method::Film;
  int shown = 0;
  Execution execution;
  execution.on_step = [&](int step, const Mesh& film) {
    if (step > 0) ++shown;
    EXPECT_FALSE(film.triangles.empty());
    for (const Triangle& t : film.triangles)
      for (int v : t) EXPECT_LT(v, static_cast<int>(film.positions.size()));
  };
  const Result result = reconstruct(points, options, execution);
  EXPECT_EQ(static_cast<std::size_t>(shown), result.report.steps.size());
  EXPECT_GT(shown, 1);
  EXPECT_GT(result.report.steps.back().attracted, 1990);
}

// A virtual site that had left was still the site of a film vertex, and the points' diagram has no such site.
TEST(Reconstruct, Regression_VirtualSiteThatLeftIsNoSiteOfTheFilm) {
  for (const auto& [name, points] : clouds()) {
    SCOPED_TRACE(name);
    Options options;
    options.method = Method::Film;
    options.virtual_sites = 200;
    options.max_steps = 12;
    expect_promise(reconstruct(points, options), points);
  }
}

TEST(Reconstruct, PointsMostlyOnAPlaneStillEncloseSomething) {
  // Only flat tetrahedra were taken of these, though each set spans space.
  const std::vector<std::vector<Point>> sets = {
      {{1, 0, 0}, {0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {0, 2, 1}},
      {{1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}, {0, 0, 2}},
      {{0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {0, 0, 2}},
      {{1, 2, 0}, {2, 2, 0}, {0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {0, 0, 2}}};
  for (const auto& points : sets) {
    const Result result = reconstruct(points);
    expect_promise(result, points);
    ASSERT_EQ(result.status, Status::Ok);
    EXPECT_GT(test::signed_volume(mesh_of(result, points)), 0);
  }
}

// CGAL's Poisson solver depended on addresses: nested spheres gave two meshes in one process.
TEST(Reconstruct, Regression_ThePapersPoissonDoesNotDependOnAddresses) {
  std::vector<Point> points = test::sphere(500, 9);
  for (const Point& p : test::sphere(500, 10, {3, 0, 0}, 0.5)) points.push_back(p);
  for (const Point& p : test::sphere(300, 11, {0, 0, 0}, 0.4)) points.push_back(p);
  const Result first = reconstruct(points, Options::paper());
  ASSERT_EQ(first.status, Status::Ok);
  std::vector<std::vector<double>> addresses;
  for (std::size_t again = 0; again < 8; ++again) {
    addresses.emplace_back(100000 * again + 17);  // so that the next run's are others
    const Result next = reconstruct(points, Options::paper());
    EXPECT_EQ(next.triangles, first.triangles);
    EXPECT_EQ(next.vertices, first.vertices);
  }
}

}  // namespace
}  // namespace filmsticking
