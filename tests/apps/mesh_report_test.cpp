// SPDX-License-Identifier: GPL-3.0-or-later
// mesh_report on shapes whose figures follow from formulas, and as a user runs it.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "io/formats.h"
#include "report/extent.h"
#include "report/holes.h"
#include "report/report.h"
#include "report/self_intersections.h"
#include "report/surface_distance.h"
#include "support/model.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

namespace filmsticking::mesh_report {
namespace {

using test::Model;
using test::Outcome;
using test::ScratchFolder;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// ---- Shapes ----

Model box(const Point& lo = {0, 0, 0}, const Point& hi = {1, 1, 1}) {
  Model model;
  for (int i = 0; i < 8; ++i)
    model.positions.push_back({i & 1 ? hi[0] : lo[0], i & 2 ? hi[1] : lo[1], i & 4 ? hi[2] : lo[2]});
  model.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {2, 6, 7}, {2, 7, 3}};
  return model;
}

/// The parallelogram from `origin` along `u` and `v`, n x n x 2 triangles.
Model plane(const Point& origin, const Point& u, const Point& v, int n) {
  Model model;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      Point p;
      for (int k = 0; k < 3; ++k) p[k] = origin[k] + u[k] * i / n + v[k] * j / n;
      model.positions.push_back(p);
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      model.triangles.push_back({a, b, b + 1});
      model.triangles.push_back({a, b + 1, a + 1});
    }
  return model;
}

/// A grid of n x n vertices closed in both directions. `twist`: the second direction comes back reversed.
Model wrapped_grid(int n, bool twist, const std::function<Point(double, double)>& at) {
  Model model;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) model.positions.push_back(at(2 * M_PI * i / n, 2 * M_PI * j / n));
  const auto id = [&](int i, int j) {
    if (i == n && twist) j = n - j;
    return i % n * n + j % n;
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      model.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      model.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return model;
}

Model torus(const Point& centre = {0, 0, 0}, int n = 40) {
  return wrapped_grid(n, false, [&](double u, double v) {
    const double r = 1 + 0.4 * std::cos(v);
    return Point{centre[0] + r * std::cos(u), centre[1] + r * std::sin(u), centre[2] + 0.4 * std::sin(v)};
  });
}

/// One-sided; the places of the vertices matter little.
Model klein_bottle() {
  return wrapped_grid(12, true, [](double u, double v) {
    return Point{std::cos(u) * (3 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v)),
                 std::sin(u) * (3 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v)),
                 std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v)};
  });
}

/// An inscribed polyhedron of parallels and meridians. The gap between two of them is that of the spheres but
/// for 0.05 %.
Model sphere(double radius) {
  constexpr int kRows = 100, kColumns = 200;
  Model model;
  for (int i = 1; i < kRows; ++i)
    for (int j = 0; j < kColumns; ++j) {
      const double theta = M_PI * i / kRows, phi = 2 * M_PI * j / kColumns;
      model.positions.push_back({radius * std::sin(theta) * std::cos(phi),
                                 radius * std::sin(theta) * std::sin(phi), radius * std::cos(theta)});
    }
  const int north = static_cast<int>(model.positions.size()), south = north + 1;
  model.positions.push_back({0, 0, radius});
  model.positions.push_back({0, 0, -radius});
  const auto id = [&](int i, int j) { return (i - 1) * kColumns + j % kColumns; };
  for (int j = 0; j < kColumns; ++j) {
    model.triangles.push_back({north, id(1, j), id(1, j + 1)});
    model.triangles.push_back({south, id(kRows - 1, j + 1), id(kRows - 1, j)});
    for (int i = 1; i + 1 < kRows; ++i) {
      model.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      model.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return model;
}

Model triangles(const std::vector<Point>& positions, const std::vector<Triangle>& faces) {
  return {positions, {}, faces};
}

Model joined(Model a, const Model& b) {
  const auto shift = static_cast<std::int32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

Model turned(Model model) {
  for (Triangle& t : model.triangles) std::swap(t[1], t[2]);
  return model;
}

Report report(const Model& model) { return report_on(make_surface(model)); }

TruthDistances distances(const Model& mesh, const Model& truth) {
  const auto result = truth_distances(make_surface(mesh), make_surface(truth), 20'000);
  EXPECT_TRUE(result.has_value());
  return result.value_or(TruthDistances{});
}

// ---- Topology ----

TEST(MeshTopology, OfABox) {
  const Report r = report(box());
  EXPECT_EQ(r.vertices, 8);
  EXPECT_EQ(r.faces, 12);
  EXPECT_EQ(r.topology.edges, 18);
  EXPECT_EQ(r.topology.boundary_edges, 0);
  EXPECT_EQ(r.topology.non_manifold_edges, 0);
  EXPECT_EQ(r.topology.non_manifold_vertices, 0);
  EXPECT_EQ(r.topology.components, 1);
  EXPECT_EQ(r.topology.genus, 0);
  EXPECT_TRUE(r.topology.closed && r.topology.manifold && r.topology.oriented && r.outward);
}

TEST(MeshTopology, OfAnOpenBox) {
  Model open = box();
  open.triangles.resize(10);
  const Report r = report(open);
  EXPECT_EQ(r.topology.boundary_edges, 4);
  EXPECT_FALSE(r.topology.closed || r.outward);
  EXPECT_TRUE(r.topology.manifold && r.topology.oriented);
  EXPECT_EQ(r.topology.genus, std::nullopt);
  EXPECT_EQ(r.volume, std::nullopt);
}

TEST(MeshTopology, OfABowTie) {
  const Report r = report(joined(box(), box({1, 1, 1}, {2, 2, 2})));  // one corner at one place
  EXPECT_EQ(r.vertices, 15);
  EXPECT_EQ(r.topology.non_manifold_vertices, 1);
  EXPECT_EQ(r.topology.non_manifold_edges, 0);
  EXPECT_EQ(r.topology.components, 1);
  EXPECT_TRUE(r.topology.closed && r.topology.oriented);
  EXPECT_FALSE(r.topology.manifold);
  EXPECT_EQ(r.topology.genus, std::nullopt);
  EXPECT_EQ(r.self_intersections, 0);
}

TEST(MeshTopology, OfAnEdgeWithThreeFaces) {
  Model fin = box();
  fin.positions.push_back({0.5, 2, 2});
  fin.triangles.push_back({6, 7, 8});
  const Report r = report(fin);
  EXPECT_EQ(r.topology.non_manifold_edges, 1);
  EXPECT_EQ(r.topology.non_manifold_vertices, 2);
  EXPECT_EQ(r.topology.boundary_edges, 2);
  EXPECT_FALSE(r.topology.closed || r.topology.manifold || r.topology.oriented);
}

TEST(MeshTopology, OfAFlippedFace) {
  Model flipped = box();
  std::swap(flipped.triangles[5][0], flipped.triangles[5][1]);
  const Report r = report(flipped);
  EXPECT_TRUE(r.topology.closed && r.topology.manifold);
  EXPECT_FALSE(r.topology.oriented || r.outward);
  EXPECT_EQ(r.topology.genus, 0);
  EXPECT_EQ(r.volume, std::nullopt);
}

TEST(MeshTopology, CountsHandlesAndPieces) {
  EXPECT_EQ(report(torus()).topology.genus, 1);
  const Topology apart =
      report(joined(joined(torus(), torus({5, 0, 0})), box({9, 0, 0}, {10, 1, 1}))).topology;
  EXPECT_EQ(apart.components, 3);
  EXPECT_EQ(apart.genus, 2);
}

TEST(MeshTopology, AOneSidedSurfaceHasNoGenus) {
  const Topology klein = report(klein_bottle()).topology;
  EXPECT_TRUE(klein.closed && klein.manifold);
  EXPECT_FALSE(klein.oriented);
  EXPECT_EQ(klein.components, 1);
  EXPECT_EQ(klein.genus, std::nullopt);
}

TEST(MeshTopology, VerticesAtOnePlaceAreOne) {
  Model soup;
  for (const Triangle& t : box({-1, 0, -1}, {1, 0.5, 1}).triangles)
    for (const std::int32_t v : t) {
      soup.positions.push_back(box({-1, 0, -1}, {1, 0.5, 1}).positions[v]);
      if (v % 3 == 0) soup.positions.back()[1] += -0.0;
      if (soup.positions.size() % 3 == 0) {
        const auto last = static_cast<std::int32_t>(soup.positions.size()) - 1;
        soup.triangles.push_back({last - 2, last - 1, last});
      }
    }
  soup.positions.push_back({7, 7, 7});  // of no face
  soup.triangles.push_back({0, 0, 1});
  const Report r = report(soup);
  EXPECT_EQ(r.vertices, 8);
  EXPECT_EQ(r.faces, 12);
  EXPECT_EQ(r.topology.genus, 0);
}

TEST(MeshTopology, MinusZeroIsZero) {
  const Model model =
      triangles({{0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {3, 4, 1}});
  EXPECT_EQ(report(model).vertices, 4);
}

TEST(MeshTopology, OfNothing) {
  for (const Model& nothing :
       {Model{}, triangles({{0, 0, 0}, {1, 0, 0}}, {}), triangles({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}}),
        triangles({{0, 0, 0}, {1, 0, 0}, {0, kNan, 0}, {0, 1e200, 0}}, {{0, 1, 2}, {0, 1, 3}})}) {
    Report r = report(nothing);
    EXPECT_EQ(r.vertices, 0);
    EXPECT_EQ(r.faces, 0);
    EXPECT_EQ(r.topology.components, 0);
    EXPECT_EQ(r.self_intersections, 0);
    EXPECT_EQ(r.area, 0);
    EXPECT_FALSE(r.topology.closed || r.topology.manifold || r.topology.oriented || r.outward);
    EXPECT_FALSE(truth_distances(make_surface(nothing), make_surface(box())));
    EXPECT_EQ(cloud_fit(make_surface(nothing), box().positions).interpolated, 0);
  }
}

// ---- Area and volume ----

TEST(MeshExtent, OfABoxWhereverItIsAndHoweverLarge) {
  for (const double away : {0.0, 1e6})
    for (const double unit : {1.0, 1e-90, 1e90}) {
      const Report r = report(box({away * unit, 0, 0}, {(away + 1) * unit, 2 * unit, 3 * unit}));
      EXPECT_NEAR(r.area / (unit * unit), 22, 1e-8);
      ASSERT_TRUE(r.volume);
      EXPECT_NEAR(*r.volume / (unit * unit * unit), 6, 1e-8);
      EXPECT_TRUE(r.outward);
    }
}

TEST(MeshExtent, InsideOutIsNegative) {
  const Report r = report(turned(box()));
  EXPECT_TRUE(r.topology.closed && r.topology.oriented);
  EXPECT_FALSE(r.outward);
  EXPECT_NEAR(r.volume.value(), -1, 1e-12);
}

TEST(MeshExtent, CavitiesAreTakenOff) {
  const Report r = report(joined(box({0, 0, 0}, {3, 3, 3}), turned(box({1, 1, 1}, {2, 2, 2}))));
  EXPECT_NEAR(r.volume.value(), 26, 1e-12);
  EXPECT_NEAR(r.area, 60, 1e-12);
  EXPECT_TRUE(r.outward);
  EXPECT_EQ(r.topology.components, 2);
}

// ---- Self-intersections ----

TEST(SelfIntersections, ByTheCornersThatFacesShare) {
  const Point a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  const auto pairs = [](const std::vector<Point>& p, const std::vector<Triangle>& t) {
    return self_intersections(make_surface(triangles(p, t))).pairs;
  };
  // None: one through the other, beside it, touching it.
  EXPECT_EQ(pairs({a, b, c, {.2, .2, -1}, {.2, .2, 1}, {-1, -1, 0}}, {{0, 1, 2}, {3, 4, 5}}), 1);
  EXPECT_EQ(pairs({a, b, c, {2, .2, -1}, {2, .2, 1}, {3, -1, 0}}, {{0, 1, 2}, {3, 4, 5}}), 0);
  EXPECT_EQ(pairs({a, b, c, {.2, .2, 0}, {.2, .2, 1}, {.3, .2, 1}}, {{0, 1, 2}, {3, 4, 5}}), 1);
  // One: apart from it, through the other's opposite side, lying on it.
  EXPECT_EQ(pairs({a, b, c, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}), 0);
  EXPECT_EQ(pairs({a, b, c, {.3, .3, 1}, {.3, .3, -1}}, {{0, 1, 2}, {0, 3, 4}}), 1);
  EXPECT_EQ(pairs({a, b, c, {.4, .2, 0}, {.2, .4, 0}}, {{0, 1, 2}, {0, 3, 4}}), 1);
  // Two: at an angle, side by side, folded onto it. Three: the same face.
  EXPECT_EQ(pairs({a, b, c, {0, -1, .1}}, {{0, 1, 2}, {1, 0, 3}}), 0);
  EXPECT_EQ(pairs({a, b, c, {0, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}), 0);
  EXPECT_EQ(pairs({a, b, c, {.1, .2, 0}}, {{0, 1, 2}, {1, 0, 3}}), 1);
  EXPECT_EQ(pairs({a, b, c}, {{0, 1, 2}, {0, 2, 1}}), 1);
  // A face without area meets nothing.
  EXPECT_EQ(pairs({a, b, c, {.2, .2, -1}, {.2, .2, 1}, {.2, .2, 0}}, {{0, 1, 2}, {3, 4, 5}}), 0);
}

TEST(SelfIntersections, OfBoxes) {
  EXPECT_EQ(report(box()).self_intersections, 0);
  EXPECT_EQ(report(joined(box(), box({2, 0, 0}, {3, 1, 1}))).self_intersections, 0);
  // A bar through two opposite sides of a box, off their diagonals: all 8 triangles of its mantle go through
  // one triangle of either side.
  const Report bar = report(joined(box({0, 0, 0}, {1, 1, 1}), box({.6, .2, -1}, {.8, .3, 2})));
  EXPECT_EQ(bar.self_intersections, 16);
  EXPECT_TRUE(bar.topology.closed && bar.topology.manifold);
}

// ---- Distances to the truth ----

TEST(TruthDistances, OfASphereInASphere) {
  // The truth's box has side 2: gaps are halved.
  const TruthDistances near = distances(sphere(0.995), sphere(1));
  EXPECT_NEAR(near.chamfer_e3, 2.5, 0.01);
  EXPECT_NEAR(near.hausdorff, 0.0025, 1e-5);
  EXPECT_EQ(near.f_score, 100);
  EXPECT_GT(near.normal_consistency, 99.9);
  const TruthDistances far = distances(sphere(0.9), sphere(1));
  EXPECT_NEAR(far.chamfer_e3, 50, 0.03);
  EXPECT_NEAR(far.hausdorff, 0.05, 3e-5);
  EXPECT_EQ(far.f_score, 0);
}

TEST(TruthDistances, OfAShiftedPlane) {
  // Also from sides and with an origin of their own: the truth's box is brought to the unit box.
  for (const double size : {1.0, 250.0}) {
    const Point origin{1000 * size, -3 * size, 0};
    const Model truth = plane(origin, {size, 0, 0}, {0, size, 0}, 7);
    const auto shifted = [&](double by) {
      return plane({origin[0], origin[1], by * size}, {0, size, 0}, {size, 0, 0}, 3);
    };
    for (const double by : {0.004, 0.006}) {
      const TruthDistances d = distances(shifted(by), truth);
      EXPECT_NEAR(d.chamfer_e3, 1000 * by, 1e-7);
      EXPECT_NEAR(d.hausdorff, by, 1e-10);
      EXPECT_EQ(d.f_score, by < 0.005 ? 100 : 0);
      EXPECT_NEAR(d.normal_consistency, 100, 1e-7);
    }
  }
}

TEST(TruthDistances, OfHalfAPlane) {
  // All of the half is on the whole; of the whole 0.505 is near, and the mean distance is 1/8.
  const TruthDistances d =
      distances(plane({0, 0, 0}, {0.5, 0, 0}, {0, 1, 0}, 4), plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4));
  EXPECT_NEAR(d.f_score, 100 * 2 * 0.505 / 1.505, 1);
  EXPECT_NEAR(d.chamfer_e3, 62.5, 2);
  EXPECT_NEAR(d.hausdorff, 0.5, 0.001);
  EXPECT_NEAR(d.normal_consistency, 100, 1e-9);
}

TEST(TruthDistances, NormalsOfATiltedPlane) {
  const double angle = 0.3;
  const Model truth = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1);
  const Model tilted = plane({0, 0, 0}, {std::cos(angle), 0, std::sin(angle)}, {0, 1, 0}, 1);
  EXPECT_NEAR(distances(tilted, truth).normal_consistency, 100 * std::cos(angle), 1e-9);
  EXPECT_NEAR(distances(turned(tilted), truth).normal_consistency, 100 * std::cos(angle), 1e-9);
}

TEST(TruthDistances, PartsThatAreTurnedOver) {
  const Model truth = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2);
  for (const double share : {0.0, 0.3, 0.8}) {
    Model mesh = plane({share, 0, 0.001}, {1 - share, 0, 0}, {0, 1, 0}, 3);
    if (share > 0) mesh = joined(mesh, turned(plane({0, 0, 0.001}, {share, 0, 0}, {0, 1, 0}, 3)));
    const double expected = 100 * std::min(share, 1 - share);
    EXPECT_NEAR(distances(mesh, truth).turned_over, expected, 1) << share;
    EXPECT_NEAR(distances(turned(mesh), truth).turned_over, expected, 1) << share;
    EXPECT_NEAR(distances(mesh, truth).normal_consistency, 100, 1e-9);
  }
}

TEST(TruthDistances, FacesWithoutAreaChangeNothing) {
  Model mesh = plane({0, 0, 0.01}, {1, 0, 0}, {0, 1, 0}, 2);
  mesh.triangles.insert(mesh.triangles.begin(), {0, 1, 2});  // on one line
  const TruthDistances d = distances(mesh, plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2));
  EXPECT_NEAR(d.chamfer_e3, 10, 1e-7);
  EXPECT_NEAR(d.hausdorff, 0.01, 1e-9);
}

TEST(SurfaceDistance, AFaceOnOneLineIsItsLongestSide) {
  std::array<std::int32_t, 3> corners{0, 1, 2};
  do {
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(-1, -2, -3), Vec3(0.1, 0.7, -0.3)}) {
      const Surface line{{0 * axis, 1 * axis, 3 * axis}, {corners}};
      const Vec3 aside = axis.unitOrthogonal();
      const auto nearest = SurfaceDistance(line).from({aside, 3 * axis + aside, 2 * axis - aside, 5 * axis});
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(nearest[i].distance, 1, 1e-12);
      EXPECT_NEAR(nearest[3].distance, 2 * axis.norm(), 1e-12);
    }
  } while (std::next_permutation(corners.begin(), corners.end()));
}

TEST(TruthDistances, NoneWithoutExtentOrArea) {
  const Model line = triangles({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  EXPECT_FALSE(truth_distances(make_surface(box()), make_surface(line)));
  EXPECT_FALSE(truth_distances(make_surface(line), make_surface(box())));
  EXPECT_FALSE(truth_distances(make_surface(box()), make_surface({})));
}

TEST(TruthFit, TopologyIsRightOrNot) {
  const auto fit = [](const Model& mesh, const Model& truth) {
    const Surface surface = make_surface(mesh);
    return truth_fit(surface, topology(surface), make_surface(truth), 10);
  };
  Model open = box();
  open.triangles.resize(10);
  const Model two = joined(box(), box({3, 0, 0}, {4, 1, 1}));
  EXPECT_TRUE(fit(box(), sphere(1)).topology_right());
  EXPECT_FALSE(fit(torus(), box()).genus_right);
  EXPECT_TRUE(fit(torus(), box()).components_right);
  EXPECT_FALSE(fit(torus(), box()).topology_right());
  EXPECT_TRUE(fit(two, box()).genus_right);
  EXPECT_FALSE(fit(two, box()).components_right);
  EXPECT_FALSE(fit(two, box()).topology_right());
  EXPECT_FALSE(fit(open, box()).topology_right());
  EXPECT_FALSE(fit(box(), open).topology_right());
  EXPECT_FALSE(fit(open, open).topology_right());
}

// ---- Distances to the cloud ----

TEST(SharpEdges, AreEdgesOfTheMeshOrNot) {
  const Surface truth = make_surface(box());
  EXPECT_EQ(sharp_edges(truth, truth).edges, 12);  // not the diagonals
  EXPECT_EQ(sharp_edges(truth, truth).restored, 100);
  Model cut = box();  // the edge from 0 to 1 is one from 3 to 5
  cut.triangles[1] = {0, 3, 5};
  cut.triangles[4] = {3, 1, 5};
  EXPECT_EQ(sharp_edges(make_surface(cut), truth).edges, 12);
  EXPECT_DOUBLE_EQ(*sharp_edges(make_surface(cut), truth).restored, 100. * 11 / 12);
  // Of its 18 edges four are diagonals of flat squares, and all but one are the box's; all the same inside
  // out.
  for (Triangle& t : cut.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(sharp_edges(truth, make_surface(cut)).edges, 14);
  EXPECT_DOUBLE_EQ(*sharp_edges(truth, make_surface(cut)).restored, 100. * 13 / 14);
  Model moved = box();
  moved.positions[0] = {0.1, 0, 0};  // three edges lack an end
  EXPECT_EQ(sharp_edges(make_surface(moved), truth).edges, 9);
  EXPECT_FALSE(sharp_edges(make_surface(box({5, 5, 5}, {6, 6, 6})), truth).restored);
  EXPECT_EQ(sharp_edges(make_surface(sphere(1)), make_surface(sphere(1))).edges, 0);
}

TEST(CloudFit, CountsDistinctPointsAndMeasures) {
  for (const double scale : {1.0, 1e-6, 1e7}) {
    Model mesh = box();
    std::vector<Point> cloud = box().positions;
    cloud.push_back({0.5, 0.5, 1.25});
    cloud.push_back({0.5, 0.25, 0});
    cloud.insert(cloud.end(), {cloud[0], cloud[3], {kNan, 0, 0}});
    for (std::vector<Point>* points : {&mesh.positions, &cloud})
      for (Point& p : *points)
        for (double& x : p) x = x * scale + 8 * scale;
    const CloudFit fit = cloud_fit(make_surface(mesh), cloud);
    EXPECT_EQ(fit.points, 10);
    EXPECT_NEAR(fit.interpolated, 80, 1e-12);
    EXPECT_NEAR(fit.distance_mean.value() / scale, 0.025, 1e-12);
    EXPECT_NEAR(fit.distance_max.value() / scale, 0.25, 1e-12);
  }
}

TEST(CloudFit, AVertexIsThePointOnlyIfItIsThere) {
  std::vector<Point> cloud = box().positions;  // diagonal sqrt(3)
  cloud[0][0] = 1e-7;
  cloud[1][0] += 2e-7;
  EXPECT_NEAR(cloud_fit(make_surface(box()), cloud).interpolated, 87.5, 1e-12);
}

TEST(CloudFit, OfLittle) {
  EXPECT_EQ(cloud_fit(make_surface(box()), {{kNan, 0, 0}}).points, 0);
  EXPECT_EQ(cloud_fit(make_surface(box()), {}).distance_mean, std::nullopt);
  const CloudFit one = cloud_fit(make_surface(box()), {{1, 1, 3}});
  EXPECT_EQ(one.points, 1);
  EXPECT_EQ(one.interpolated, 0);
  EXPECT_NEAR(one.distance_max.value(), 2, 1e-12);
}

// ---- Components, holes, a plane ----

TEST(Components, HaveTheirOwnAreaAndVolume) {
  Model open = box({5, 0, 0}, {6, 1, 1});
  open.triangles.resize(10);
  const std::vector<Component> parts =
      components(make_surface(joined(joined(box(), open), box({0, 5, 0}, {3, 7, 1}))));
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_DOUBLE_EQ(parts[0].area, 22);
  EXPECT_NEAR(parts[0].volume.value(), 6, 1e-12);
  EXPECT_NEAR(parts[1].volume.value(), 1, 1e-12);
  EXPECT_EQ(parts[2].faces, 10);
  EXPECT_FALSE(parts[2].closed);
  EXPECT_DOUBLE_EQ(parts[2].area, 5);
  EXPECT_FALSE(parts[2].volume);
  EXPECT_TRUE(components(make_surface({})).empty());
}

TEST(Holes, AreLoopsWithTheirMeasures) {
  Model open = box({0, 0, 0}, {3, 4, 1});
  open.triangles.resize(2);  // the lower side alone
  Surface surface = make_surface(open);
  std::vector<Hole> all = holes(surface, sides_by_edge(surface));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].vertices.size(), 4u);
  EXPECT_DOUBLE_EQ(all[0].length, 14);
  EXPECT_NEAR(all[0].diameter, 5, 1e-9);
  EXPECT_NEAR((all[0].centre - Vec3(1.5, 2, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((all[0].area_vector - Vec3(0, 0, 12)).norm(), 0, 1e-9);  // a lid looks the other way
  surface = make_surface(box());
  EXPECT_TRUE(holes(surface, sides_by_edge(surface)).empty());
}

TEST(Holes, ThatTouchAreSeveral) {
  Model grid = plane({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 4);
  // Two cells that share a corner are left out.
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < grid.triangles.size(); ++t)
    if (t / 2 != 5 && t / 2 != 10) kept.push_back(grid.triangles[t]);
  grid.triangles = kept;
  const Surface surface = make_surface(grid);
  const std::vector<Hole> all = holes(surface, sides_by_edge(surface));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_DOUBLE_EQ(all[0].length, 16);
  EXPECT_DOUBLE_EQ(all[1].length, 4);
  EXPECT_DOUBLE_EQ(all[2].area(), 1);
}

TEST(Holes, HaveMeasuresWhereverTheyAre) {
  for (const double scale : {1e-30, 1e60}) {
    Model open = box();
    open.triangles.resize(10);
    for (Point& p : open.positions)
      for (double& x : p) x = (x + 7) * scale;
    const Surface surface = make_surface(open);
    const std::vector<Hole> all = holes(surface, sides_by_edge(surface));
    ASSERT_EQ(all.size(), 1u);
    EXPECT_NEAR(all[0].diameter / scale, std::sqrt(2), 1e-6);
  }
}

TEST(PlaneVolumes, AreOnBothSidesOfThePlane) {
  for (const double scale : {1.0, 1e-9, 1e7}) {
    const Vec3 up = Vec3(1, 2, -2) / 3;
    Model mesh = torus({0, 0, 0}, 200);
    for (Point& p : mesh.positions)
      for (double& x : p) x *= scale;
    const Surface surface = make_surface(mesh);
    const double volume = extent(surface).signed_volume;
    const PlaneVolumes half = plane_volumes(surface, up, 0);  // through the middle
    EXPECT_NEAR(half.above / volume, 0.5, 1e-3);
    EXPECT_NEAR((half.above + half.below) / volume, 1, 1e-9);
    EXPECT_NEAR(half.net / volume, 1, 1e-9);
    const PlaneVolumes all = plane_volumes(surface, up, 9 * scale);
    EXPECT_NEAR(all.above / volume, 1, 1e-9);
    EXPECT_EQ(all.below, 0);
  }
}

TEST(PlaneVolumes, OfAnOpenSurfaceAreFillAndCut) {
  // A square 2 x 2 that leans from -1 to 1: a wedge above, the same below.
  const Surface roof = make_surface(plane({0, 0, -1}, {2, 0, 2}, {0, 2, 0}, 3));
  const PlaneVolumes volumes = plane_volumes(roof, Vec3::UnitZ(), 0);
  EXPECT_NEAR(volumes.above, 1, 1e-12);
  EXPECT_NEAR(volumes.below, 1, 1e-12);
  EXPECT_NEAR(volumes.net, 0, 1e-12);
  const PlaneVolumes high = plane_volumes(roof, Vec3::UnitZ(), 5);
  EXPECT_NEAR(high.above, 20, 1e-12);
}

// ---- The whole ----

TEST(MeshReport, IsTheSameWithAnyNumberOfThreads) {
  const Surface mesh = make_surface(joined(torus(), torus({0.3, 0.2, 0.1}))), truth = make_surface(torus());
  const auto all = [&] {
    Report r = report_on(mesh);
    r.cloud = cloud_fit(mesh, torus({0, 0, 0.01}).positions);
    r.truth = truth_fit(mesh, r.topology, truth, 5000);
    return to_json(r);
  };
  std::string alone;
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    alone = all();
  }
  const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
  EXPECT_EQ(all(), alone);
}

TEST(MeshReport, JsonHasNoInfinity) {
  Report r;
  r.area = std::numeric_limits<double>::infinity();
  EXPECT_NE(to_json(r).find("\"area\": null"), std::string::npos);
}

// ---- The program ----

using Json = nlohmann::json;

std::set<std::string> names(const Json& json) {
  std::set<std::string> result;
  for (const auto& [name, value] : json.items()) result.insert(name);
  return result;
}

Outcome mesh_report(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), MESH_REPORT);
  return test::run_program(arguments);
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
        test::run_program({evalmesh, folder / "mesh.ply", folder / "truth.ply", folder / "truth.ply"});
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
}  // namespace filmsticking::mesh_report
