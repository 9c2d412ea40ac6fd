// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/restricted_power_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "film/initial_surface.h"
#include "geometry/triangle_adjacency.h"
#include "support/power_cells.h"

namespace filmsticking {
namespace {

// The owners of finely spaced places along an edge are the edge's cells, in order. Returns the most cells of
// an edge.
std::size_t expect_owners_met(const Surface& surface, const RestrictedPowerDiagram& restricted,
                              const PowerDiagram& diagram) {
  const std::vector<char> all(diagram.position.size(), 1);
  std::size_t most = 0;
  for (Index h = 0; h < static_cast<Index>(restricted.edge.size()); ++h) {
    if (!restricted.forward[h]) continue;
    const Index e = restricted.edge[h];
    const Vec3 from = surface.corner(h / 3, h % 3), to = surface.corner(h / 3, (h % 3 + 1) % 3);
    std::vector<Index> met;
    for (int i = 0; i <= 200; ++i) {
      const Index o = test::brute_owner(diagram, from + (to - from) * (i / 200.0), all);
      if (met.empty() || met.back() != o) met.push_back(o);
    }
    const std::vector<Index> cells(restricted.cell.begin() + restricted.offset[e],
                                   restricted.cell.begin() + restricted.offset[e + 1]);
    std::size_t k = 0;
    for (Index c : cells) k += k < met.size() && met[k] == c;
    EXPECT_EQ(k, met.size()) << "edge " << e;
    // No cell occurs twice, and consecutive cells are neighbours.
    EXPECT_EQ(std::set<Index>(cells.begin(), cells.end()).size(), cells.size()) << "edge " << e;
    for (std::size_t i = 0; i + 1 < cells.size(); ++i)
      EXPECT_TRUE(std::binary_search(diagram.neighbour.begin() + diagram.offset[cells[i]],
                                     diagram.neighbour.begin() + diagram.offset[cells[i] + 1], cells[i + 1]))
          << "edge " << e;
    most = std::max(most, cells.size());
  }
  return most;
}

RestrictedPowerDiagram restricted_to(const Surface& surface, const PowerDiagram& diagram) {
  return restrict_power_diagram(
      surface, half_edge_twins(surface.triangles, static_cast<Index>(surface.positions.size())), diagram);
}

TEST(RestrictedPowerDiagram, EdgesRunThroughTheCellsThatOwnThem) {
  const auto sites = test::random_sites(400, 7);
  std::vector<double> weights(400, 0);
  for (int i = 0; i < 400; i += 5) weights[i] = 0.01;
  const std::vector<char> all(400, 1);
  for (const PowerDiagram& diagram :
       {DelaunayTriangulation(sites).voronoi(), weighted_power_diagram(sites, weights, all)}) {
    const Surface sphere = bounding_sphere(sites);
    expect_owners_met(sphere, restricted_to(sphere, diagram), diagram);
  }
}

// On a moment curve all sites are neighbours: a walk took time quadratic in the sites.
TEST(RestrictedPowerDiagram, Regression_OfSitesThatAreAllNeighboursAWalkIsNotQuadratic) {
  std::vector<Vec3> sites;
  for (int i = 0; i < 300; ++i) {
    const double x = i / 150.0 - 1;
    sites.emplace_back(x, x * x, x * x * x);
  }
  Surface tetrahedron;
  tetrahedron.positions = {{-1.1, 0, -1}, {1.1, 0, 1}, {0, 1.1, -1}, {0, 0.9, 1}};
  tetrahedron.site.assign(4, kNone);
  tetrahedron.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  std::vector<double> weights(300, 0);
  for (int i = 0; i < 300; i += 5) weights[i] = 1e-5;
  for (const PowerDiagram& diagram : {DelaunayTriangulation(sites).voronoi(),
                                      weighted_power_diagram(sites, weights, std::vector<char>(300, 1))}) {
    const RestrictedPowerDiagram restricted = restricted_to(tetrahedron, diagram);
    EXPECT_GT(expect_owners_met(tetrahedron, restricted, diagram), 100);
    EXPECT_EQ(restricted.jumps, 0);
    EXPECT_LE(restricted.looks, 6 * 20 * 300);
  }
}

}  // namespace
}  // namespace filmsticking
