// SPDX-License-Identifier: GPL-3.0-or-later
// Options::open_boundary: its guarantees, on generated and real clouds.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>

#include "filmsticking/reconstruct.h"
#include "support/clouds.h"
#include "support/surface_check.h"

namespace filmsticking {
namespace {

Result reconstruct_open(const std::vector<Point>& points) {
  Options options;
  options.open_boundary = true;
  return reconstruct(points, options);
}

void expect_open_manifold(const Result& result, const std::vector<Point>& points) {
  ASSERT_EQ(result.status, Status::Ok) << result.message;
  Mesh mesh;
  for (std::int32_t i : result.vertices) mesh.positions.push_back(points.at(i));
  mesh.triangles = result.triangles;
  EXPECT_EQ(test::surface_fault(mesh, true), "");
  EXPECT_TRUE(result.report.manifold);
  EXPECT_EQ(result.report.closed, result.report.boundary_edges == 0);
  EXPECT_EQ(result.gaps.size(), result.triangles.size());
}

// The fraction of the faces in the component with most of them.
double largest_share(const Result& result) {
  std::vector<std::size_t> root(result.vertices.size()), count(root.size(), 0);
  for (std::size_t v = 0; v < root.size(); ++v) root[v] = v;
  const auto find = [&](std::size_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const Triangle& t : result.triangles) root[find(t[1])] = find(t[0]), root[find(t[2])] = find(t[0]);
  for (const Triangle& t : result.triangles) ++count[find(t[0])];
  return static_cast<double>(*std::max_element(count.begin(), count.end())) /
         static_cast<double>(result.triangles.size());
}

// A sheet over the square [0, 2]^2, turned so that no axis is special.
std::vector<Point> sheet(int n, std::uint64_t seed, double wave) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 2);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double u = uniform(random), v = uniform(random), w = wave * std::sin(3 * u) * std::cos(2 * v);
    points.push_back({0.6 * u - 0.8 * w, v, 0.8 * u + 0.6 * w});
  }
  return points;
}

std::vector<Point> part_of_sphere(int n, std::uint64_t seed, double lowest) {
  std::vector<Point> points;
  for (const Point& p : test::sphere(n, seed))
    if (p[2] > lowest) points.push_back(p);
  return points;
}

// Of 180 such sheets one in twenty has a handle or a patch too many, in whichever directions its axes are.
TEST(OpenBoundary, ASheetIsASheet) {
  int others = 0;
  for (const double wave : {0.05, 0.2, 0.4})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE(std::to_string(wave) + " " + std::to_string(seed));
      const auto points = sheet(3000, seed, wave);
      const Result result = reconstruct_open(points);
      expect_open_manifold(result, points);
      EXPECT_LE(result.report.components, 4);
      EXPECT_LE(result.report.boundary_loops, 7);  // the rim, and a pinhole or two near it
      EXPECT_GE(static_cast<double>(result.report.interpolated), 0.995 * static_cast<double>(points.size()));
      others += result.report.genus != 0 || largest_share(result) < 0.99;
    }
  EXPECT_LE(others, 2);
}

TEST(OpenBoundary, APartOfASphereIsADisc) {
  for (const double lowest : {-0.7, 0.0, 0.5, 0.8})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(std::to_string(lowest) + " " + std::to_string(seed));
      const auto points = part_of_sphere(6000, seed, lowest);
      const Result result = reconstruct_open(points);
      expect_open_manifold(result, points);
      EXPECT_EQ(result.report.components, 1);
      EXPECT_EQ(result.report.boundary_loops, 1);
      EXPECT_EQ(result.report.genus, 0);
    }
}

// Its repair strips tetrahedra of the hull from an inside that reaches infinity. Their corner at infinity was
// taken for a site.
TEST(OpenBoundary, Regression_AnInsideThatReachesInfinityIsStripped) {
  const std::vector<Point> points = {{31747934631.487381, -31747934631.182289, 1277598866.4814167},
                                     {31747934631.632729, -31747934632.090782, 1277598865.6612034},
                                     {31747934631.81823, -31747934630.969273, 1277598865.4602494},
                                     {31747934630.888912, -31747934631.739296, 1277598865.4935341},
                                     {31747934631.605503, -31747934632.077919, 1277598865.6550665},
                                     {31747934631.764297, -31747934632.152954, 1277598865.690861},
                                     {31747934631.158337, -31747934631.866611, 1277598865.5542676},
                                     {31747934631.832058, -31747934632.184975, 1277598865.7061353},
                                     {31747934631.807671, -31747934630.97607, 1277598865.4928448},
                                     {31747934631.293289, -31747934631.930382, 1277598865.5846877},
                                     {31747934631.87606, -31747934630.932037, 1277598865.2817512},
                                     {31747934631.29797, -31747934631.932594, 1277598865.585743},
                                     {31747934631.769917, -31747934631.000378, 1277598865.6093628},
                                     {31747934631.141045, -31747934631.85844, 1277598865.550369},
                                     {31747934630.656754, -31747934631.629593, 1277598865.4412019},
                                     {31747934630.489471, -31747934631.550545, 1277598865.4034936},
                                     {31747934631.828136, -31747934630.962894, 1277598865.4296765},
                                     {31747934631.841183, -31747934630.954494, 1277598865.3894053},
                                     {31747934631.619343, -31747934632.084457, 1277598865.658186},
                                     {31747934630.463303, -31747934631.538181, 1277598865.3975949},
                                     {31747934631.561657, -31747934631.134464, 1277598866.2521584},
                                     {31747934631.779453, -31747934630.994236, 1277598865.5799313},
                                     {31747934631.147823, -31747934631.861645, 1277598865.551897},
                                     {31747934631.933685, -31747934630.894936, 1277598865.1038916},
                                     {31747934631.67984, -31747934631.058376, 1277598865.8873937},
                                     {31747934631.240864, -31747934631.905609, 1277598865.5728703},
                                     {31747934631.663616, -31747934631.068817, 1277598865.9374597},
                                     {31747934631.776955, -31747934632.158936, 1277598865.6937146},
                                     {31747934630.993637, -31747934631.788784, 1277598865.5171409},
                                     {31747934631.843193, -31747934630.953197, 1277598865.3831933},
                                     {31747934631.792473, -31747934632.166267, 1277598865.6972122}};
  const Result result = reconstruct_open(points);
  if (result.status == Status::Ok) expect_open_manifold(result, points);
  EXPECT_TRUE(result.status == Status::Ok || result.status == Status::NoSurface) << result.message;
}

TEST(OpenBoundary, ClosedWithoutTheOption) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const auto& points : {sheet(3000, seed, 0.3), part_of_sphere(4000, seed, 0.2)}) {
      const Result result = reconstruct(points);
      ASSERT_EQ(result.status, Status::Ok);
      EXPECT_TRUE(result.report.closed && result.report.manifold);
      EXPECT_LE(result.report.components, 4);  // a wavy sheet may be closed on both sides
      // Of a dozen such sheets 95 to 99 % are on; which, hangs on ties in the repair.
      EXPECT_GE(static_cast<double>(result.report.interpolated), 0.95 * static_cast<double>(points.size()));
    }
}

// Of the faces that samples support, the share of those that show their fronts along `view(p)` from their
// first corner p.
template <class View>
double fronts(const Result& result, const std::vector<Point>& points, const View& view) {
  int with = 0, against = 0;
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    if (result.gaps[t] > 4) continue;
    const auto at = [&](int k) {
      const Point& p = points.at(result.vertices[result.triangles[t][k]]);
      return Eigen::Vector3d(p[0], p[1], p[2]);
    };
    const Eigen::Vector3d a = at(0), b = at(1), c = at(2);
    ++((b - a).cross(c - a).dot(view(a)) > 0 ? with : against);
  }
  return static_cast<double>(with) / std::max(1, with + against);
}

// The share of those that are turned the way most are.
template <class View>
double facing(const Result& result, const std::vector<Point>& points, const View& view) {
  const double share = fronts(result, points, view);
  return std::max(share, 1 - share);
}

// The closed surface of a sheet wound through it, half of it seen from behind, as faces that nothing supports
// were dearer than that. A sheet that waves through the plane of its rim is closed on both sides: a flat lid
// cuts it there.
TEST(OpenBoundary, Regression_ASheetThatIsClosedFacesOneWay) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto cap = part_of_sphere(4000, seed, 0.2), bowl = part_of_sphere(4000, seed, -0.3);
    for (const auto& points : {cap, bowl})
      EXPECT_GE(facing(reconstruct(points), points, [](const Eigen::Vector3d& p) { return p; }), 0.98)
          << seed;
  }
  for (const char* name : {"bun0.pcd", "bun4.pcd"}) {
    const auto points = test::read_text_pcd(std::string(TEST_DATA "/") + name);
    const Result result = reconstruct(points);
    EXPECT_TRUE(result.report.closed) << name;
    EXPECT_GE(static_cast<double>(result.report.interpolated), 0.98 * static_cast<double>(points.size()))
        << name;
    EXPECT_GE(facing(result, points, [](const Eigen::Vector3d&) { return Eigen::Vector3d(0, 0, 1); }), 0.85)
        << name;
  }
}

// With middles in [-1, 1]^3.
std::vector<std::array<double, 4>> spheres(test::Random& random, int n, double least, double most) {
  std::vector<std::array<double, 4>> all;
  for (int i = 0; i < n; ++i)
    all.push_back(
        {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(least, most)});
  return all;
}

auto towards(const Point& eye) {
  return [eye](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return Eigen::Vector3d(eye[0], eye[1], eye[2]) - p;
  };
}

// A surface was seen from behind in parts, with a seam of holes through the middle of what is sampled well:
// clusters of tetrahedra before it and behind it had met first around its rim. Pieces of their own were
// turned by chance.
TEST(OpenBoundary, Regression_ADepthViewFacesTheCamera) {
  const Point eye{0.3, -0.2, 6};
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const auto points = test::depth_view(spheres(random, 7, 0.3, 0.7), eye, 0.006);
    const Result result = reconstruct_open(points);
    expect_open_manifold(result, points);
    EXPECT_FALSE(result.report.closed);
    EXPECT_GE(static_cast<double>(result.report.interpolated), 0.995 * static_cast<double>(points.size()));
    EXPECT_GE(facing(result, points, towards(eye)), 0.9);
    EXPECT_GE(fronts(result, points, towards(eye)), 0.9);
  }
}

// In noise as large as half the gaps between them, a third of the points was seen from behind: what facets
// say of their neighbours does not reach across silhouettes, but the point that all of them are seen from
// does.
TEST(OpenBoundary, Regression_ANoisyDepthViewFacesTheCamera) {
  const Point eye{0.3, -0.2, 6};
  constexpr double kPixel = 0.002, kKept = 0.3;
  const double noise = 0.5 * eye[2] * kPixel / std::sqrt(kKept);
  for (std::uint64_t seed = 2; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    std::vector<Point> points;
    for (Point p : test::depth_view(spheres(random, 30, 0.1, 0.27), eye, kPixel)) {
      if (random.uniform(0, 1) > kKept) continue;
      for (double& x : p) x += noise * random.uniform(-1, 1);
      points.push_back(p);
    }
    const Result result = reconstruct_open(points);
    expect_open_manifold(result, points);
    // The others are faces along the lines of sight, which noise turns.
    EXPECT_GE(fronts(result, points, towards(eye)), 0.87);
  }
}

// Faces around two points as near as this were said to meet, and taken away: half the surface was gone.
TEST(OpenBoundary, Regression_NearPointsDoNotTearASheet) {
  for (const double apart : {3e-8, 6e-8, 2e-7}) {
    SCOPED_TRACE(apart);
    std::vector<Point> points = sheet(1500, 1, 0.2), twice = points;
    test::Random random(2);
    for (const Point& p : points)
      twice.push_back({p[0] + 2 * apart * random.uniform(-1, 1), p[1] + 2 * apart * random.uniform(-1, 1),
                       p[2] + 2 * apart * random.uniform(-1, 1)});
    const Result once = reconstruct_open(points), result = reconstruct_open(twice);
    expect_open_manifold(result, twice);
    // Some faces between so near points cut others.
    EXPECT_GE(10 * result.triangles.size(), 18 * once.triangles.size());
    EXPECT_LE(result.report.boundary_edges, 5 * once.report.boundary_edges);
  }
}

TEST(OpenBoundary, ClosedCloudsStayAsTheyAre) {
  const std::map<std::string, std::vector<Point>> clouds = {
      {"sphere", test::sphere(3000, 1)},
      {"torus", test::torus(5000, 2)},
      {"box", test::box(4000, 3, {1, 2, 1})},
      {"thin plate", test::box(3000, 6, {1, 1, 0.02})},
      {"spot", test::read_float_ply(TEST_DATA "/spot_10k.ply")}};
  for (const auto& [name, points] : clouds) {
    SCOPED_TRACE(name);
    const Result closed = reconstruct(points), open = reconstruct_open(points);
    EXPECT_TRUE(open.report.closed);
    EXPECT_EQ(open.triangles, closed.triangles);
    EXPECT_EQ(open.gaps, closed.gaps);
  }
}

TEST(OpenBoundary, AThinClosedShellIsNotTakenForASheet) {
  // Two spheres so near that their points are as far from each other as from their neighbours.
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    auto points = test::sphere(2500, seed);
    for (const Point& p : test::sphere(2500, seed + 100, {0, 0, 0}, 1.07)) points.push_back(p);
    const Result result = reconstruct_open(points);
    ASSERT_EQ(result.status, Status::Ok);
    // A chance gap may stay; a sheet has a rim.
    EXPECT_LE(result.report.boundary_edges, 20) << seed;
    EXPECT_LE(result.report.boundary_loops, 1) << seed;
  }
}

TEST(OpenBoundary, Regression_AFunnelOfAThinWallGotALid) {
  // Two funnels joined at their necks, the wall a fifth as thick as the points are apart: its sides cannot be
  // distinguished, but what closes the mouths is supported by nothing.
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Point> points;
    while (points.size() < 5000) {
      const double z = 2 * unit(random) - 1, radius = std::sqrt(0.04 + 0.74 * z * z);
      const double angle = 2 * std::acos(-1) * unit(random), wall = unit(random) < 0.5 ? -0.007 : 0.007;
      if (unit(random) < radius)  // evenly by area
        points.push_back({(radius + wall) * std::cos(angle), (radius + wall) * std::sin(angle), z});
    }
    const Result result = reconstruct(points);
    ASSERT_EQ(result.status, Status::Ok) << result.message;
    double area = 0, lids = 0;
    for (const auto& t : result.triangles) {
      const Eigen::Map<const Eigen::Vector3d> a(points[result.vertices[t[0]]].data()),
          b(points[result.vertices[t[1]]].data()), c(points[result.vertices[t[2]]].data());
      const double twice = (b - a).cross(c - a).norm();
      area += twice;
      if (std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}) > 0.4) lids += twice;
    }
    EXPECT_LT(lids, 0.02 * area) << "seed " << seed;
  }
}

TEST(OpenBoundary, ScansFromOneSide) {
  for (const char* name : {"bun0.pcd", "bun4.pcd"}) {
    SCOPED_TRACE(name);
    const auto points = test::read_text_pcd(std::string(TEST_DATA "/") + name);
    ASSERT_GT(points.size(), 300u);
    const Result result = reconstruct_open(points);
    expect_open_manifold(result, points);
    EXPECT_FALSE(result.report.closed);
    EXPECT_GE(largest_share(result), 0.9);
    EXPECT_GE(static_cast<double>(result.report.interpolated), 0.95 * static_cast<double>(points.size()));
  }
}

TEST(OpenBoundary, GapsAreSmallOnASampledSurfaceAndLargeAcrossAHole) {
  const Result full = reconstruct(test::sphere(4000, 7));
  ASSERT_EQ(full.gaps.size(), full.triangles.size());
  EXPECT_LT(*std::max_element(full.gaps.begin(), full.gaps.end()), 5);
  EXPECT_GT(*std::min_element(full.gaps.begin(), full.gaps.end()), 0);
  const Result part = reconstruct(part_of_sphere(4000, 7, -0.3));
  EXPECT_GT(*std::max_element(part.gaps.begin(), part.gaps.end()), 8);
}

// A surface that is closed although it might be open is oriented as any closed surface.
TEST(OpenBoundary, AClosedOneEnclosesPositiveVolume) {
  int closed = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::vector<Point> points = test::awkward(seed);
    Options options;
    options.open_boundary = true;
    const Result result = reconstruct(points, options);
    if (result.status != Status::Ok || !result.report.closed) continue;
    Mesh mesh;
    for (const std::int32_t i : result.vertices) mesh.positions.push_back(points[i]);
    mesh.triangles = result.triangles;
    EXPECT_GT(test::signed_volume(mesh), 0) << seed;
    ++closed;
  }
  EXPECT_GT(closed, 10);
}

}  // namespace
}  // namespace filmsticking
