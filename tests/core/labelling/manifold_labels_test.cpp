// SPDX-License-Identifier: GPL-3.0-or-later
// ManifoldLabels: the repair, the warp, the reach and the unfolding.
#include "labelling/manifold_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "labelling/label_islands.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

// A plate on the axes: its sides are flat, and so are the tetrahedra of four samples of one side.
TEST(ManifoldLabels, UnfoldLeavesTheTopology) {
  std::int64_t unfolded = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Setting s(test::box(300, seed, {1, 1, 0.05}));
    EXPECT_GT(std::count_if(s.mesh.flat.begin(), s.mesh.flat.end(), [](int side) { return side != 0; }), 0);
    std::vector<char> inside = test::random_labels(s.mesh, seed);
    const LabelCosts costs = costs_of(s);
    ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
    manifold.repair();
    const test::Topology before = test::topology(s, inside);
    manifold.unfold();
    ASSERT_TRUE(euler_if_manifold(s, inside)) << seed;
    const test::Topology after = test::topology(s, inside);
    EXPECT_EQ(after.handles, before.handles) << seed;
    EXPECT_EQ(after.components, before.components) << seed;
    unfolded += manifold.counts().unfolded;
    const std::int64_t once = manifold.counts().unfolded;
    manifold.unfold();
    EXPECT_EQ(manifold.counts().unfolded, once) << seed;
  }
  EXPECT_GT(unfolded, 0);
}

// Places where the surface of a plate on the axes touches itself: a site of it strictly within a facet of it,
// where all four are corners of a tetrahedron and have the very same height.
int pinches(const Setting& s, const std::vector<Point>& points, const std::vector<char>& inside) {
  std::vector<char> on(s.set.size(), 0);
  for (const Index v : test::film_of(s, inside).site) on[v] = 1;
  const auto left = [](const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  };
  int count = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
    const auto& corners = s.mesh.tets.corners[t];
    const auto at = [&](int k) { return points[s.set.input[corners[k]]]; };
    for (int k = 0; k < 4; ++k) {
      if (!on[corners[k]] || inside[s.mesh.tets.neighbours[t][k]] == inside[t]) continue;
      const Point p = at(k), a = at(kFacet[k][0]), b = at(kFacet[k][1]), c = at(kFacet[k][2]);
      if (p[2] != a[2] || p[2] != b[2] || p[2] != c[2]) continue;
      const double sign = left(a, b, c) < 0 ? -1 : 1;
      count += sign * left(a, b, p) > 0 && sign * left(b, c, p) > 0 && sign * left(c, a, p) > 0;
    }
  }
  return count;
}

// Such were left on plates of half a spacing, where a sample of one side hung from the other: here from the
// facet of a tetrahedron between them, which is taken out.
TEST(ManifoldLabels, Regression_ASiteInAFaceGoesOverToItsSheet) {
  int before = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const std::vector<Point> points = test::box(300, seed, {1, 1, 0.1});
    const Setting s(points);
    const LabelCosts costs = costs_of(s);
    const std::vector<char> full = test::labels_where(s, [](const Point&) { return true; });
    for (std::size_t t = 0; t < s.mesh.size(); ++t) {
      const auto& beside = s.mesh.tets.neighbours[t];
      if (!full[t] || s.mesh.flat[t] ||
          std::all_of(beside.begin(), beside.end(), [&](Index u) { return full[u]; }))
        continue;
      std::vector<char> inside = full;
      inside[t] = 0;
      ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
      manifold.repair();
      const int now = pinches(s, points, inside);
      if (manifold.counts().singular > 0 || now == 0) continue;
      before += now;
      manifold.unfold();
      ASSERT_TRUE(euler_if_manifold(s, inside));
      EXPECT_EQ(pinches(s, points, inside), 0) << seed;
    }
  }
  EXPECT_GT(before, 0);
}

TEST(ManifoldLabels, AreAManifoldInEveryRoomForAnyLabels) {
  std::int64_t singular = 0, reached = 0, tunnels = 0, tears = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Setting s(seed % 2 ? test::sphere(120, seed) : test::torus(200, seed));
    std::vector<char> inside = test::random_labels(s.mesh, seed);
    const LabelCosts costs = costs_of(s);
    ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
    manifold.repair();
    EXPECT_TRUE(euler_if_manifold(s, inside)) << seed;
    manifold.warp(test::random_labels(s.mesh, seed + 1000));
    EXPECT_TRUE(euler_if_manifold(s, inside)) << seed;
    manifold.reach();
    EXPECT_TRUE(euler_if_manifold(s, inside)) << seed;
    const test::Topology before = test::topology(s, inside);
    manifold.fill_plugs();
    ASSERT_TRUE(euler_if_manifold(s, inside)) << seed;
    EXPECT_LE(test::topology(s, inside).handles, before.handles) << seed;
    EXPECT_LE(test::topology(s, inside).components, before.components) << seed;
    manifold.fill_gaps(s.set.perturbed);
    ASSERT_TRUE(euler_if_manifold(s, inside)) << seed;
    const test::Topology after = test::topology(s, inside);
    EXPECT_LE(after.handles, before.handles) << seed;
    EXPECT_LE(after.components, before.components) << seed;
    EXPECT_EQ((after.handles < before.handles), (manifold.counts().tunnels > 0)) << seed;
    EXPECT_EQ((after.components < before.components), (manifold.counts().tears > 0)) << seed;
    tunnels += manifold.counts().tunnels, tears += manifold.counts().tears;
    singular += manifold.counts().singular, reached += manifold.counts().reached;
    for (std::size_t t = 0; t < inside.size(); ++t)
      EXPECT_FALSE(inside[t] && s.mesh.tets.infinite(static_cast<Index>(t)));
  }
  EXPECT_GT(singular, 0);  // there was something to do
  EXPECT_GT(reached, 0);
  EXPECT_GT(tunnels, 0);
  EXPECT_GT(tears, 0);
}

// A star is first searched as a list; a piece that was met when the list was full was written past its end,
// and what came after it.
TEST(ManifoldLabels, Regression_AStarMayBeLongerThanTheListByAPiece) {
  std::vector<Point> points = test::sphere(60, 1);
  points.push_back({0, 0, 0});
  const Setting s(points);
  const LabelCosts costs = costs_of(s);
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    test::Random random(seed);
    std::vector<char> inside(s.mesh.size(), 0);
    for (std::size_t t = 0; t < inside.size(); ++t)
      inside[t] = !s.mesh.tets.infinite(static_cast<Index>(t)) && random.below(12) > 0;
    ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
    manifold.repair();
    EXPECT_TRUE(euler_if_manifold(s, inside)) << seed;
  }
}

// Of random labels of these points, `between` the repair and the gaps: a manifold, and no more work than the
// bound.
template <class Between>
LabelCounts expect_bounded_work(const std::vector<Point>& points, const Between& between) {
  const Setting s(points);
  const LabelCosts costs = costs_of(s);
  std::vector<char> inside = test::random_labels(s.mesh, 1);
  ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
  manifold.repair();
  EXPECT_TRUE(euler_if_manifold(s, inside));
  between(s, manifold);
  manifold.fill_gaps(s.set.perturbed);
  EXPECT_TRUE(euler_if_manifold(s, inside));
  EXPECT_LE(manifold.counts().visits, 11000 * static_cast<std::int64_t>(points.size()));
  return manifold.counts();
}

// On a moment curve: the repair took the fourth power of the sites, minutes for 2,000.
TEST(ManifoldLabels, Regression_OfSitesThatAreAllNeighboursTheWorkIsBounded) {
  std::vector<Point> points;
  for (int i = 0; i < 300; ++i) {
    const double x = i / 150.0 - 1;
    points.push_back({x, x * x, x * x * x});
  }
  const LabelCounts counts = expect_bounded_work(points, [](const Setting& s, ManifoldLabels& manifold) {
    manifold.warp(test::random_labels(s.mesh, 2));
    manifold.reach();
  });
  EXPECT_GT(counts.stripped, 0);  // the bound was met
}

// The tetrahedra around one edge are as many as the sites; the search for threads walked around it for each
// of them.
TEST(ManifoldLabels, Regression_TheSearchForThreadsIsBounded) {
  std::vector<Point> points{{0, 0, 0.05}, {0, 0, -0.05}};
  const int n = 4000;
  for (int i = 0; i < n; ++i) points.push_back({std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 0});
  for (const Point& p : test::torus(300, 1, 0.1, 0.04)) points.push_back({p[0] + 3, p[1], p[2]});
  expect_bounded_work(points, [](const Setting&, ManifoldLabels&) {});
}

TEST(ManifoldLabels, WarpAndReachKeepTheTopology) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Setting s(test::torus(300, seed));
    std::vector<char> inside = test::random_labels(s.mesh, seed);
    const LabelCosts costs = costs_of(s);
    ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
    manifold.repair();
    const auto before = euler_if_manifold(s, inside);
    manifold.warp(test::random_labels(s.mesh, seed + 1000));
    EXPECT_EQ(euler_if_manifold(s, inside), before) << seed;
    manifold.reach();
    EXPECT_EQ(euler_if_manifold(s, inside), before) << seed;
  }
}

// Below 1 inside the ellipsoid at x0.
double level(const Setting& s, std::size_t t, double x0) {
  const Point p = s.set.to_input(s.centre(t));
  return Vec3(p[0] - x0, p[1] / 0.8, p[2] / 0.6).norm();
}

TEST(ManifoldLabels, WarpReachesTheAimWhereTheTopologyIsTheSame) {
  const Setting s(test::ellipsoid(2000, 3, 0));
  std::vector<char> aim(s.mesh.size()), inside(s.mesh.size());
  for (std::size_t t = 0; t < aim.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
    aim[t] = level(s, t, 0) < 0.99;
    inside[t] = aim[t] && s.set.to_input(s.centre(t))[0] < 0.4;  // with its end cut off
  }
  const LabelCosts costs = costs_of(s);
  ManifoldLabels whole(s.mesh, s.geometry, costs, aim);
  whole.repair();
  ManifoldLabels part(s.mesh, s.geometry, costs, inside);
  part.repair();
  part.warp(aim);
  std::size_t differences = 0;
  for (std::size_t t = 0; t < aim.size(); ++t) differences += aim[t] != inside[t];
  EXPECT_GT(part.counts().warped, 100);
  // Some steps need two tetrahedra at once: of two dozen such clouds, 0 to 14 % stay different.
  EXPECT_LT(differences, static_cast<std::size_t>(part.counts().warped) / 5);
}

TEST(ManifoldLabels, AnIslandIsGivenUpAndAPartIsKept) {
  std::vector<Point> points = test::ellipsoid(2000, 4, 0);
  for (const Point& p : test::ellipsoid(2000, 5, 3)) points.push_back(p);
  const Setting s(points);
  std::vector<char> inside(s.mesh.size());
  Index island = kNone;
  for (std::size_t t = 0; t < inside.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
    const double left = level(s, t, 0), right = level(s, t, 3);
    inside[t] = right < 0.99;  // all of the right one; of the left one a single tetrahedron
    if (left > 0.9 && left < 0.98) island = static_cast<Index>(t);
  }
  ASSERT_NE(island, kNone);
  inside[island] = 1;
  EXPECT_GE(drop_islands(s.mesh, s.geometry, inside), 1);
  EXPECT_FALSE(inside[island]);
  for (std::size_t t = 0; t < inside.size(); ++t)
    if (!s.mesh.tets.infinite(static_cast<Index>(t)) && level(s, t, 3) < 0.9) {
      EXPECT_TRUE(inside[t]) << t;
    }
}

}  // namespace
}  // namespace filmsticking
