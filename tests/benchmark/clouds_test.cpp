// SPDX-License-Identifier: GPL-3.0-or-later
// The clouds that the methods are compared on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <stdexcept>

#include "clouds/make_cloud.h"
#include "clouds/shapes.h"
#include "clouds/surface_sampler.h"
#include "support/surface_check.h"

namespace filmsticking::bench {
namespace {

constexpr Sampling kSamplings[] = {Sampling::MonteCarlo, Sampling::PoissonDisk, Sampling::MixedDensity,
                                   Sampling::DepthView};

CloudSpec spec_of(Sampling sampling, std::int64_t points, std::uint64_t seed = 1) {
  CloudSpec spec;
  spec.sampling = sampling;
  spec.points = points;
  spec.seed = seed;
  return spec;
}

/// A box from the origin to `size`.
Mesh make_box(const Point& size) {
  Mesh box = make_shape("slab:1", 100);
  for (Point& p : box.positions)
    for (int k = 0; k < 3; ++k) p[k] = p[k] > 0 ? size[k] : 0;
  return box;
}

double distance_to_box(const Point& p, const Point& size) {
  double nearest = INFINITY;  // for points inside or on it
  for (int k = 0; k < 3; ++k) nearest = std::min({nearest, std::abs(p[k]), std::abs(p[k] - size[k])});
  return nearest;
}

double norm(const Point& p) { return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]); }

double distance(const Point& a, const Point& b) { return norm({a[0] - b[0], a[1] - b[1], a[2] - b[2]}); }

double least_distance(const std::vector<Point>& points) {
  double least = INFINITY;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, distance(points[i], points[j]));
  return least;
}

template <class Good>
double share(const std::vector<Point>& points, const Good& good) {
  return static_cast<double>(std::count_if(points.begin(), points.end(), good)) /
         static_cast<double>(points.size());
}

int euler_characteristic(const Mesh& mesh) {  // of a closed mesh
  const auto faces = static_cast<int>(mesh.triangles.size());
  return static_cast<int>(mesh.positions.size()) - faces * 3 / 2 + faces;
}

int count_components(const Mesh& mesh) {
  std::vector<int> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int vertex) {
    while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
    return vertex;
  };
  for (const Triangle& t : mesh.triangles) {
    parent[root(t[0])] = root(t[1]);
    parent[root(t[1])] = root(t[2]);
  }
  int roots = 0;
  for (std::size_t i = 0; i < parent.size(); ++i) roots += parent[i] == static_cast<int>(i) ? 1 : 0;
  return roots;
}

TEST(Clouds, PointsLieOnTheSurfaceInFloatsAndNoneTwice) {
  const Point size = {1, 0.7, 2};
  const Mesh box = make_box(size);
  for (const Sampling sampling : kSamplings)
    for (const int count : {1, 7, 3000}) {
      const std::vector<Point> points = make_cloud(box, spec_of(sampling, count));
      ASSERT_EQ(points.size(), static_cast<std::size_t>(count)) << name_of(sampling);
      EXPECT_EQ(std::set<Point>(points.begin(), points.end()).size(), points.size()) << name_of(sampling);
      for (const Point& p : points) {
        ASSERT_LT(distance_to_box(p, size), 1e-6) << name_of(sampling);
        for (const double x : p) {
          const volatile float single = static_cast<float>(x);
          ASSERT_EQ(static_cast<double>(single), x);
        }
      }
    }
}

TEST(Clouds, SameSeedSamePointsOtherSeedOtherPoints) {
  const Mesh sphere = make_shape("sphere", 1);
  for (const Sampling sampling : kSamplings) {
    CloudSpec spec = spec_of(sampling, 500, 3);
    spec.noise.deviation = 0.01;
    spec.outliers = 0.1;
    spec.missing = is_depth(sampling) ? 0 : 0.2;
    const std::vector<Point> points = make_cloud(sphere, spec);
    EXPECT_EQ(points, make_cloud(sphere, spec)) << name_of(sampling);
    spec.seed = 4;
    EXPECT_NE(points, make_cloud(sphere, spec)) << name_of(sampling);
  }
}

TEST(Clouds, MonteCarloIsUniformByArea) {
  const Point size = {1, 1, 3};  // 2 of 14 on top and bottom
  const std::vector<Point> points = make_cloud(make_box(size), spec_of(Sampling::MonteCarlo, 20000));
  EXPECT_NEAR(share(points, [](const Point& p) { return p[2] == 0 || p[2] == 3; }), 2.0 / 14, 0.01);
  EXPECT_NEAR(share(points, [](const Point& p) { return p[2] > 0 && p[2] < 1; }), 4.0 / 14, 0.015);
}

TEST(Clouds, PoissonDiskKeepsADistance) {
  constexpr int kCount = 2000;
  const Mesh sphere = make_shape("sphere", 1);
  // The densest packing has its neighbours at 2 r with r = sqrt(area / (2 sqrt(3) n)).
  const double densest = 2 * std::sqrt(4 * M_PI / (2 * std::sqrt(3) * kCount));
  EXPECT_GT(least_distance(make_cloud(sphere, spec_of(Sampling::PoissonDisk, kCount))), 0.6 * densest);
  EXPECT_LT(least_distance(make_cloud(sphere, spec_of(Sampling::MonteCarlo, kCount))), 0.1 * densest);
}

TEST(Clouds, PoissonDiskSamplesTheSidesOfAPlateForThemselves) {
  const Point size = {1, 1, 1e-4};
  const std::vector<Point> points = make_cloud(make_box(size), spec_of(Sampling::PoissonDisk, 2000));
  EXPECT_NEAR(share(points, [](const Point& p) { return p[2] == 0; }), 0.5, 0.03);
}

TEST(Clouds, MixedDensityIsAsFourToTwoToOne) {
  const Mesh box = make_box({1, 1, 3});  // areas of the thirds 5, 4, 5
  const std::vector<Point> points = make_cloud(box, spec_of(Sampling::MixedDensity, 6600));
  const double unit = 1.0 / (4 * 5 + 2 * 4 + 1 * 5);
  EXPECT_NEAR(share(points, [](const Point& p) { return p[2] >= 2; }), 20 * unit, 0.02);
  EXPECT_NEAR(share(points, [](const Point& p) { return p[2] < 2 && p[2] >= 1; }), 8 * unit, 0.02);
  EXPECT_NEAR(share(points, [](const Point& p) { return p[2] < 1; }), 5 * unit, 0.02);
  // 4000 on top, where they keep a distance; 1600 in the middle, where they do not.
  std::vector<Point> top, middle;
  for (const Point& p : points) {
    if (p[2] >= 2) top.push_back(p);
    if (p[2] < 2 && p[2] >= 1) middle.push_back(p);
  }
  const double densest = 2 * std::sqrt(5 / (2 * std::sqrt(3) * 4000));
  // Across an edge of the box the way through the air is shorter than the one on the surface.
  EXPECT_GT(least_distance(top), 0.4 * densest);
  EXPECT_LT(least_distance(middle), 0.2 * densest);
}

TEST(Clouds, NoiseHasItsDeviation) {
  CloudSpec spec = spec_of(Sampling::MonteCarlo, 20000);
  const Mesh sphere = make_shape("sphere", 1);
  const auto expect_deviation = [&](double sigma) {
    double sum = 0, squares = 0;
    for (const Point& p : make_cloud(sphere, spec)) {
      const double off = norm(p) - 1;
      sum += off;
      squares += off * off;
    }
    EXPECT_NEAR(std::sqrt(squares / 20000), sigma, 0.05 * sigma);
    EXPECT_NEAR(sum / 20000, 0, 0.1 * sigma);
  };
  spec.noise = {0.005, false};
  expect_deviation(0.005 * 2 * std::sqrt(3.0));  // the sphere's box has sides of 2
  spec.noise = {0.5, true};
  expect_deviation(0.5 * std::sqrt(4 * M_PI / 20000));
}

TEST(Clouds, OutliersHaveTheirShareAndStayInTheBox) {
  CloudSpec spec = spec_of(Sampling::MonteCarlo, 10000);
  spec.outliers = 0.2;
  const std::vector<Point> points = make_cloud(make_shape("sphere", 1), spec);
  ASSERT_EQ(points.size(), 10000U);
  // A shell of 0.01 around the sphere holds 3 % of the box.
  const double off = share(points, [](const Point& p) { return std::abs(norm(p) - 1) > 0.01; });
  EXPECT_LE(off, 0.2);
  EXPECT_GT(off, 0.185);
  EXPECT_EQ(share(points,
                  [](const Point& p) {
                    return std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}) <= 1;
                  }),
            1);
}

TEST(Clouds, PatchesAreMissing) {
  const Mesh sphere = make_shape("sphere", 1);
  Random random(5);
  SurfaceSampler holed(sphere);
  const double whole = holed.area();
  EXPECT_NEAR(whole, 4 * M_PI, 0.01 * 4 * M_PI);
  holed.take_patches_away(0.3, random);
  EXPECT_NEAR(holed.area(), 0.7 * whole, 1e-3 * whole);
  const auto missing = [&](const Vec3& p) {
    return std::any_of(holed.holes().begin(), holed.holes().end(),
                       [&](const auto& hole) { return (p - hole.centre).norm() <= hole.radius; });
  };
  const SurfaceSampler full(sphere);
  int in_holes = 0;
  for (int i = 0; i < 20000; ++i) {
    ASSERT_FALSE(missing(holed.draw(random).position));
    in_holes += missing(full.draw(random).position) ? 1 : 0;
  }
  EXPECT_NEAR(in_holes / 20000.0, 0.3, 0.02);
}

TEST(Clouds, VerticesAreThoseOfTheFacesOnceEach) {
  Mesh box = make_box({1, 2, 3});
  std::set<Point> corners(box.positions.begin(), box.positions.end());
  box.positions.push_back({9, 9, 9});  // of no face
  box.positions.push_back(box.positions[box.triangles[0][0]]);
  box.triangles.push_back(
      {static_cast<std::int32_t>(box.positions.size()) - 1, box.triangles[0][2], box.triangles[0][1]});
  const std::vector<Point> points = make_cloud(box, spec_of(Sampling::Vertices, 3));
  EXPECT_EQ(points.size(), corners.size());
  EXPECT_EQ(std::set<Point>(points.begin(), points.end()), corners);
  CloudSpec damaged = spec_of(Sampling::Vertices, 3);
  damaged.missing = 0.1;
  EXPECT_THROW(make_cloud(box, damaged), std::invalid_argument);
}

// Of a sphere of radius 1, a camera that is d away from its middle sees what is more than 1 / d on its side.
TEST(Clouds, DepthViewsAreOfWhatTheCameraSees) {
  const Mesh sphere = make_shape("sphere", 20000);
  const double horizon = 1 / (2 * std::sqrt(12));
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const CloudSpec spec = spec_of(Sampling::DepthView, 5000, seed);
    const std::vector<Point> points = make_cloud(sphere, spec);
    ASSERT_EQ(points.size(), 5000u);
    Point sum{};
    for (const Point& p : points)
      for (int k = 0; k < 3; ++k) sum[k] += p[k];
    const auto height = [&](const Point& p) {
      return (p[0] * sum[0] + p[1] * sum[1] + p[2] * sum[2]) / norm(sum);
    };
    for (const Point& p : points) EXPECT_GT(height(p), horizon - 0.03);
    const Mesh seen = sampled_part(sphere, spec);
    double lowest = 1;
    for (const Point& p : seen.positions) lowest = std::min(lowest, height(p));
    EXPECT_NEAR(lowest, horizon, 0.05);
    EXPECT_NEAR(SurfaceSampler(seen).area(), 2 * M_PI * (1 - horizon), 0.1);
  }
}

TEST(Clouds, ADepthFrameIsADepthViewInTheCamerasFrame) {
  const Mesh box = make_box({1, 2, 3});
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const CloudSpec view = spec_of(Sampling::DepthView, 2000, seed),
                    frame = spec_of(Sampling::DepthFrame, 2000, seed);
    const std::vector<Point> there = make_cloud(box, view), here = make_cloud(box, frame);
    ASSERT_EQ(here.size(), there.size());
    EXPECT_NEAR(distance(here[0], here[1]), distance(there[0], there[1]), 1e-5);
    for (std::size_t i = 0; i < here.size(); ++i) {
      EXPECT_GT(here[i][2], 0);
      // The middle of the box is straight ahead, two diagonals away.
      const double off = distance(here[i], {0, 0, 2 * std::sqrt(14)}),
                   same = distance(there[i], {0.5, 1, 1.5});
      EXPECT_NEAR(off, same, 1e-5);
    }
    for (const Point& p : sampled_part(box, frame).positions)
      EXPECT_LE(distance(p, {0, 0, 2 * std::sqrt(14)}), std::sqrt(14) / 2 + 1e-5);
  }
}

TEST(Clouds, WhatCannotBeSampledIsRefused) {
  EXPECT_THROW(make_cloud({}, CloudSpec()), std::invalid_argument);
  EXPECT_THROW(make_cloud(make_box({1, 0, 0}), CloudSpec()), std::invalid_argument);
  CloudSpec spec;
  spec.points = 0;
  EXPECT_THROW(make_cloud(make_box({1, 1, 1}), spec), std::invalid_argument);
  spec = CloudSpec();
  spec.missing = 1;
  EXPECT_THROW(make_cloud(make_box({1, 1, 1}), spec), std::invalid_argument);
  spec = spec_of(Sampling::DepthView, 100);
  spec.missing = 0.1;
  EXPECT_THROW(make_cloud(make_box({1, 1, 1}), spec), std::invalid_argument);
  spec = CloudSpec();
  spec.noise.deviation = NAN;
  EXPECT_THROW(make_cloud(make_box({1, 1, 1}), spec), std::invalid_argument);
}

TEST(Shapes, AreClosedAndOutwardWithTheirTopology) {
  struct Known {
    const char* name;
    int components, genus;
  };
  for (const Known& known : {Known{"sphere", 1, 0},
                             {"torus", 1, 1},
                             {"slab:0.5", 1, 0},
                             {"shell:0.5", 1, 0},
                             {"relief:1", 1, 0},
                             {"mouth:4", 1, 0},
                             {"bottle:4", 1, 0},
                             {"spiral:4", 1, 0},
                             {"nested", 3, 0},
                             {"chain:2", 5, 5},
                             {"lattice:2", 1, 54 - 27 + 1}}) {
    const Mesh mesh = make_shape(known.name, 5000);
    EXPECT_EQ(test::surface_fault(mesh), "") << known.name;
    EXPECT_GT(test::signed_volume(mesh), 0) << known.name;
    EXPECT_EQ(count_components(mesh), known.components) << known.name;
    EXPECT_EQ(euler_characteristic(mesh), 2 * known.components - 2 * known.genus) << known.name;
  }
}

TEST(Shapes, AreAsWideAsSoManySpacings) {
  const auto upper = [](const Mesh& mesh) {  // the first corner of a plate's upper side
    return mesh.positions[mesh.positions.size() / 2];
  };
  const auto least = [](const Mesh& mesh, const auto& measure) {
    double found = INFINITY;
    for (const Point& p : mesh.positions) found = std::min(found, measure(p));
    return found;
  };
  const auto to_axis = [](const Point& p) { return 2 * std::hypot(p[0], p[1]) + (p[2] > 0 ? 0 : 9); };
  struct Sized {
    const char* family;
    std::function<double(const Mesh&)> size;
    double tolerance;
  };
  const Sized families[] = {
      {"slab", [&](const Mesh& mesh) { return upper(mesh)[2]; }, 1e-3},
      {"relief", [&](const Mesh& mesh) { return upper(mesh)[2]; }, 1e-3},
      {"shell", [&](const Mesh& mesh) { return norm(upper(mesh)) - 1; }, 1e-3},
      {"mouth", [&](const Mesh& mesh) { return least(mesh, to_axis); }, 0.05},
      {"bottle", [&](const Mesh& mesh) { return least(mesh, to_axis); }, 0.05},
      {"spiral",
       [&](const Mesh& mesh) {
         return least(mesh,
                      [](const Point& p) { return 2 * std::hypot(p[0] - 0.5, p[1]) + (p[2] > 0.5 ? 0 : 9); });
       },
       0.05},
      // The first ring and the first tube, seen from their middle lines; no tubes cross there.
      {"chain", [&](const Mesh& mesh) { return -1 - least(mesh, [](const Point& p) { return p[0]; }); },
       0.05},
      {"lattice",
       [&](const Mesh& mesh) {
         return -least(mesh, [](const Point& p) { return std::abs(p[0] - 0.5) < 0.1 ? p[1] : 0; });
       },
       0.05}};
  for (const Sized& sized : families) {
    const Mesh mesh = make_shape(std::string(sized.family) + ":2", 5000);
    const double wanted = 2 * std::sqrt(SurfaceSampler(mesh).area() / 5000);
    EXPECT_NEAR(sized.size(mesh), wanted, sized.tolerance * wanted) << sized.family;
  }
}

TEST(Shapes, WhatCannotBeMadeIsRefused) {
  for (const char* name :
       {"slab:", "slab:0", "slab:-1", "slab:x", "slab:1x", "slab:nan", "slab:inf", "slab", "plate:1"})
    EXPECT_THROW(make_shape(name, 1000), std::invalid_argument) << name;
  EXPECT_THROW(make_shape("chain:3", 100), std::invalid_argument);      // no room within the rings
  EXPECT_THROW(make_shape("mouth:1e-3", 1000), std::invalid_argument);  // finer than memory allows
}

}  // namespace
}  // namespace filmsticking::bench
