// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <utility>

#include "report/report.h"
#include "support/shapes.h"

namespace filmsticking::mesh_report {
namespace {

using test::box;
using test::joined;
using test::klein_bottle;
using test::Model;
using test::torus;
using test::triangles;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Report report(const Model& model) { return report_on(make_surface(model)); }

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

}  // namespace
}  // namespace filmsticking::mesh_report
