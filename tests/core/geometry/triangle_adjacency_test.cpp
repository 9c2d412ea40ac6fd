// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_adjacency.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

TEST(TriangleAdjacency, AcceptsAClosedManifold) { EXPECT_TRUE(check_manifold(test::kTetrahedron, 4).ok()); }

TEST(TriangleAdjacency, SeesEveryKindOfFault) {
  EXPECT_FALSE(check_manifold({}, 0).ok());
  EXPECT_FALSE(check_manifold({{0, 1, 9}}, 3).indices_valid);
  EXPECT_FALSE(check_manifold({{0, 1, 1}}, 3).indices_valid);
  auto open = test::kTetrahedron;
  open.pop_back();
  EXPECT_FALSE(check_manifold(open, 4).closed);
  auto turned = test::kTetrahedron;
  std::swap(turned[0][0], turned[0][1]);
  EXPECT_FALSE(check_manifold(turned, 4).oriented);
  auto bow_tie = test::kTetrahedron;  // two tetrahedra that share corner 0 only
  for (const Corners& t : test::kTetrahedron) {
    Corners u;
    for (int k = 0; k < 3; ++k) u[k] = t[k] == 0 ? 0 : t[k] + 3;
    bow_tie.push_back(u);
  }
  const ManifoldCheck check = check_manifold(bow_tie, 7);
  EXPECT_TRUE(check.closed && check.oriented);
  EXPECT_FALSE(check.single_rings);
  std::vector<Index> component;
  EXPECT_EQ(connected_components(half_edge_twins(bow_tie, 7), component), 2);
}

TEST(TriangleAdjacency, KnownTwinsAreCheckedToo) {
  const std::vector<Corners> tetrahedron{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  std::vector<Index> twins = half_edge_twins(tetrahedron, 4);
  EXPECT_TRUE(check_manifold_with_twins(tetrahedron, 4, twins).ok());
  EXPECT_FALSE(check_manifold_with_twins(tetrahedron, 3, twins).ok());
  EXPECT_FALSE(check_manifold_with_twins({}, 4, {}).ok());
  EXPECT_FALSE(check_manifold_with_twins(tetrahedron, 4, {}).ok());
  std::swap(twins[0], twins[1]);
  EXPECT_FALSE(check_manifold_with_twins(tetrahedron, 4, twins).ok());
  // Two tetrahedra on one edge: its four faces pair up, but the rings at its ends are two.
  std::vector<Corners> two = tetrahedron;
  for (Corners c : tetrahedron) {
    for (Index& v : c) v = v < 2 ? v : v + 2;
    two.push_back(c);
  }
  std::vector<Index> both = half_edge_twins(tetrahedron, 4);
  for (std::size_t h = 0; h < 12; ++h) both.push_back(both[h] + 12);
  EXPECT_FALSE(check_manifold_with_twins(two, 6, both).ok());
  EXPECT_TRUE(check_manifold_with_twins(two, 6, both).edges_simple);
}

TEST(TriangleAdjacency, FlipsKeepATwinnedManifold) {
  Surface surface = test::ball();
  std::vector<Index> twins = test::twins_of(surface);
  test::Random random(1);
  int flips = 0;
  for (int i = 0; i < 300; ++i) {
    const auto h = static_cast<Index>(random.below(static_cast<int>(twins.size())));
    const Index c = prev_in_face(h), d = prev_in_face(twins[h]);
    const auto corner = [&](Index g) { return surface.triangles[g / 3][g % 3]; };
    if (corner(c) == corner(d) || have_edge(surface.triangles, twins, c, d)) continue;
    const std::array<Index, 2> ends{corner(c), corner(d)};
    flip_edge(surface.triangles, twins, h);
    ++flips;
    EXPECT_EQ(corner(h), ends[1]);
    EXPECT_EQ(corner(next_in_face(h)), ends[0]);
    ASSERT_EQ(twins, test::twins_of(surface));
  }
  EXPECT_GT(flips, 100);
  EXPECT_TRUE(test::check(surface).ok());
}

TEST(TriangleAdjacency, HaveEdgeAgreesWithTheListOfEdges) {
  const Surface sheet = test::square_sheet(5, 1);
  const std::vector<Index> twins = test::twins_of(sheet);
  std::set<std::pair<Index, Index>> edges;
  std::vector<Index> out(sheet.positions.size(), kNone);
  for (Index h = 0; h < static_cast<Index>(twins.size()); ++h) {
    const Index a = sheet.triangles[h / 3][h % 3], b = sheet.triangles[h / 3][(h + 1) % 3];
    edges.insert(std::minmax(a, b));
    out[a] = h;
  }
  for (Index a = 0; a < static_cast<Index>(out.size()); ++a)
    for (Index b = 0; b < a; ++b)
      EXPECT_EQ(have_edge(sheet.triangles, twins, out[a], out[b]), edges.count({b, a}) > 0) << a << ' ' << b;
}

TEST(TriangleAdjacency, CountsComponentsAndBoundaryLoops) {
  EXPECT_EQ(boundary_loops(test::twins_of(test::ball())), 0);
  EXPECT_EQ(boundary_loops(test::twins_of(test::square_sheet(4, 1))), 1);
  const Surface belt = test::ball_without([](const Vec3& p) { return std::abs(p.z()) > 0.4; });
  const SurfaceTopology topology(belt.triangles, static_cast<Index>(belt.positions.size()));
  EXPECT_EQ(topology.components, 1);
  EXPECT_EQ(boundary_loops(topology.twin), 2);
  const Surface caps = test::ball_without([](const Vec3& p) { return std::abs(p.z()) < 0.4; });
  EXPECT_EQ(SurfaceTopology(caps.triangles, static_cast<Index>(caps.positions.size())).components, 2);
}

}  // namespace
}  // namespace filmsticking
