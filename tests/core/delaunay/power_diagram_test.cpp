// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/power_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "delaunay/delaunay.h"
#include "film/attraction_weights.h"
#include "film/initial_surface.h"
#include "film/restricted_power_diagram.h"
#include "film/virtual_sites.h"
#include "geometry/nearest.h"
#include "geometry/triangle_adjacency.h"
#include "points/site_set.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

std::vector<Vec3> random_sites(int n, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Vec3> sites;
  for (int i = 0; i < n; ++i)
    sites.emplace_back(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
  return sites;
}

Index brute_owner(const PowerDiagram& diagram, const Vec3& x, const std::vector<char>& present) {
  Index best = kNone;
  for (Index i = 0; i < static_cast<Index>(diagram.position.size()); ++i)
    if (present[i] && (best == kNone || diagram.power(i, x) < diagram.power(best, x))) best = i;
  return best;
}

TEST(PowerDiagram, OwnerIsTheNearestSiteFromAnyHint) {
  const PowerDiagram diagram = DelaunayTriangulation(random_sites(300, 1)).voronoi();
  const std::vector<char> all(300, 1);
  test::Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Vec3 x(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
    EXPECT_EQ(diagram.owner(x, random.below(300)), brute_owner(diagram, x, all));
  }
}

TEST(PowerDiagram, WeightsHideAndAbsentSitesHaveNoCell) {
  const auto sites = random_sites(200, 3);
  test::Random random(4);
  std::vector<double> weights(200, 0);
  std::vector<char> present(200, 1);
  for (int i = 0; i < 200; ++i) weights[i] = random.uniform(0, 0.05), present[i] = random.below(10) > 0;
  const PowerDiagram diagram = weighted_power_diagram(sites, weights, present);
  for (int i = 0; i < 200; ++i)
    if (!present[i]) {
      EXPECT_FALSE(diagram.has_cell(i));
    }
  for (int i = 0; i < 500; ++i) {
    const Vec3 x(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    EXPECT_EQ(diagram.owner(x, kNone), brute_owner(diagram, x, present));
  }
}

TEST(PowerDiagram, SitesCanLeave) {
  DelaunayTriangulation triangulation(random_sites(100, 5));
  std::vector<char> present(100, 1);
  for (int i = 0; i < 100; i += 3) triangulation.remove(i), present[i] = 0;
  triangulation.remove(0);  // again: nothing happens
  const PowerDiagram diagram = triangulation.voronoi();
  test::Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Vec3 x(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    EXPECT_EQ(diagram.owner(x, 0), brute_owner(diagram, x, present));
  }
}

// The owners that are met on a fine walk along an edge are its cells, in their order. Returns the most cells
// of an edge.
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
      const Index o = brute_owner(diagram, from + (to - from) * (i / 200.0), all);
      if (met.empty() || met.back() != o) met.push_back(o);
    }
    const std::vector<Index> cells(restricted.cell.begin() + restricted.offset[e],
                                   restricted.cell.begin() + restricted.offset[e + 1]);
    std::size_t k = 0;
    for (Index c : cells) k += k < met.size() && met[k] == c;
    EXPECT_EQ(k, met.size()) << "edge " << e;
    // No cell twice, and each borders on the next where the edge goes from one to the other.
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
  const auto sites = random_sites(400, 7);
  std::vector<double> weights(400, 0);
  for (int i = 0; i < 400; i += 5) weights[i] = 0.01;
  const std::vector<char> all(400, 1);
  for (const PowerDiagram& diagram :
       {DelaunayTriangulation(sites).voronoi(), weighted_power_diagram(sites, weights, all)}) {
    const Surface sphere = bounding_sphere(sites);
    expect_owners_met(sphere, restricted_to(sphere, diagram), diagram);
  }
}

// On a moment curve: a walk took the square of the sites.
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

TEST(AttractionWeights, StayInThePapersInterval) {
  const SiteSet set = make_site_set(test::sphere(500, 8));
  Surface film = bounding_sphere(set.perturbed);
  std::vector<Index> off;
  for (Index s = 0; s < static_cast<Index>(set.size()); ++s) off.push_back(s);
  std::vector<double> weights;
  const std::size_t weighted = attraction_weights(film, set.perturbed, off, weights);
  EXPECT_GT(weighted, 0u);
  const SurfaceTree surface(film);
  for (std::size_t s = 0; s < weights.size(); ++s) {
    if (weights[s] == 0) continue;
    double to_vertex2 = 1e300;
    for (const Vec3& v : film.positions)
      to_vertex2 = std::min(to_vertex2, (v - set.perturbed[s]).squaredNorm());
    EXPECT_GT(weights[s], (surface.nearest(set.perturbed[s]).point - set.perturbed[s]).squaredNorm());
    EXPECT_LT(weights[s], to_vertex2);
  }
}

TEST(AttractionWeights, ASiteBehindAnotherWaits) {
  const Surface film = bounding_sphere({{0.5, 0.5, 0.5}});
  const Vec3 out = Vec3(1, 0.2, 0.3).normalized();
  std::vector<double> weights;
  attraction_weights(film, {0.6 * out, 0.3 * out}, {0, 1}, weights);
  EXPECT_GT(weights[0], 0);
  EXPECT_EQ(weights[1], 0);
}

TEST(Nearest, AgreesWithBruteForce) {
  const auto points = random_sites(1000, 9);
  const PointTree tree(points);
  for (const Vec3& x : random_sites(50, 10)) {
    std::vector<std::pair<double, Index>> all;
    for (std::size_t i = 0; i < points.size(); ++i)
      all.emplace_back((points[i] - x).squaredNorm(), static_cast<Index>(i));
    std::sort(all.begin(), all.end());
    const auto near = tree.nearest(x, 15);
    ASSERT_EQ(near.size(), 15u);
    for (int k = 0; k < 15; ++k) EXPECT_EQ(near[k], all[k].second);
  }
  EXPECT_EQ(PointTree({}).nearest({0, 0, 0}), kNone);
}

TEST(VirtualSites, AreFarFromSitesAndFromEachOther) {
  const SiteSet set = make_site_set(test::torus(2000, 11));
  const TetrahedralMesh mesh = make_tetrahedral_mesh(delaunay_tetrahedra(set.perturbed), set.perturbed);
  const std::vector<double> spacing(set.size(), 0.03);
  const PointTree sites(set.perturbed);
  const std::vector<char> all(mesh.size(), 1), none(mesh.size(), 0);
  for (const int count : {50, -1}) {
    const auto chosen = virtual_sites(mesh, spacing, count, all);
    EXPECT_FALSE(chosen.empty());
    if (count > 0) {
      EXPECT_LE(chosen.size(), 50u);
    }
    for (const Vec3& v : chosen) {
      double d2 = 0;
      sites.nearest(v, &d2);
      EXPECT_GT(std::sqrt(d2), 0.0599);
    }
    EXPECT_TRUE(virtual_sites(mesh, spacing, count, none).empty());
  }
}

}  // namespace
}  // namespace filmsticking
