// SPDX-License-Identifier: GPL-3.0-or-later
// The film step: dual complex, manifold repair, evolution, insertion.
#include "film/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "film/dual_complex.h"
#include "film/initial_surface.h"
#include "film/insert_sites.h"
#include "geometry/triangle_adjacency.h"
#include "points/site_set.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

void expect_closed(const HalfEdgeComplex& c) {
  for (Index h = 0; h < static_cast<Index>(c.twin.size()); ++h) {
    ASSERT_EQ(c.twin[c.twin[h]], h);
    ASSERT_NE(c.twin[h], h);
    ASSERT_EQ(c.site[c.twin[h]], c.site[next_in_face(h)]);
  }
}

void expect_manifold(const Surface& film) {
  EXPECT_TRUE(check_manifold(film.triangles, static_cast<Index>(film.positions.size())).ok());
  std::vector<Index> sites = film.site;
  std::sort(sites.begin(), sites.end());
  EXPECT_TRUE(std::adjacent_find(sites.begin(), sites.end()) == sites.end())
      << "a site stands on two vertices";
}

TEST(DualComplex, IsClosedWhateverTheSites) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const std::vector<Point> points = test::awkward(seed);
    const SiteSet set = make_site_set(points);
    if (set.size() < 4) continue;
    std::vector<Vec3> exact;  // ties and all
    for (std::size_t s = 0; s < set.size(); ++s) exact.push_back(set.exact(points, s));
    const PowerDiagram diagram = DelaunayTriangulation(exact).voronoi();
    if (diagram.any_site == kNone) continue;
    const Surface sphere = bounding_sphere(exact);
    const auto restricted = restrict_power_diagram(
        sphere, half_edge_twins(sphere.triangles, static_cast<Index>(sphere.positions.size())), diagram);
    expect_closed(dual_complex(sphere, restricted, diagram));
  }
}

TEST(DualComplex, TriplePointsAreEquallyFarFromTheirSites) {
  const SiteSet set = make_site_set(test::sphere(400, 1));
  const PowerDiagram diagram = DelaunayTriangulation(set.perturbed).voronoi();
  const Surface sphere = bounding_sphere(set.perturbed);
  const auto restricted = restrict_power_diagram(
      sphere, half_edge_twins(sphere.triangles, static_cast<Index>(sphere.positions.size())), diagram);
  const HalfEdgeComplex dual = dual_complex(sphere, restricted, diagram);
  ASSERT_FALSE(dual.point.empty());
  for (std::size_t t = 0; t < dual.point.size(); ++t) {
    const double d = diagram.power(dual.site[3 * t], dual.point[t]);
    for (int k = 1; k < 3; ++k) EXPECT_NEAR(diagram.power(dual.site[3 * t + k], dual.point[t]), d, 1e-9);
    EXPECT_NEAR(diagram.power(diagram.owner(dual.point[t], kNone), dual.point[t]), d, 1e-9);
  }
}

// Triangles with random corners from a few sites, glued at random wherever the ends of two half-edges agree:
// the worst that could be handed to the repair.
HalfEdgeComplex random_complex(std::uint64_t seed) {
  test::Random random(seed);
  const int sites = 3 + random.below(12), pairs = 1 + random.below(60);
  HalfEdgeComplex c;
  for (int i = 0; i < pairs; ++i) {
    Index a = random.below(sites), b = random.below(sites), d = random.below(sites);
    if (a == b || b == d || a == d) continue;
    c.site.insert(c.site.end(),
                  {a, b, d, a, d, b});  // a triangle and its back, so that all half-edges can pair
    c.point.insert(c.point.end(), 2, Vec3::Zero());
  }
  c.twin.assign(c.site.size(), kNone);
  std::vector<Index> order(c.site.size());
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(static_cast<int>(i))]);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Index h = order[i];
    for (std::size_t j = i + 1; j < order.size() && c.twin[h] == kNone; ++j) {
      const Index g = order[j];
      if (c.twin[g] == kNone && c.site[g] == c.site[next_in_face(h)] && c.site[next_in_face(g)] == c.site[h])
        c.twin[h] = g, c.twin[g] = h;
    }
  }
  return c;
}

TEST(ManifoldRepair, MakesAManifoldOfAnyClosedComplex) {
  int kept = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const HalfEdgeComplex complex = random_complex(seed);
    expect_closed(complex);
    test::Random random(seed);
    std::vector<Vec3> positions;
    for (int i = 0; i < 16; ++i) positions.emplace_back(random.uniform(), random.uniform(), random.uniform());
    for (const RingChoice ring : {RingChoice::Smooth, RingChoice::Nearest}) {
      RepairCounts counts;
      const Surface film = surface_of_sites(repair_half_edges(complex, positions, ring, counts), positions);
      if (film.triangles.empty()) continue;
      ++kept;
      expect_manifold(film);
    }
  }
  EXPECT_GT(kept, 500);  // the test is about surfaces, not about empty ones
}

TEST(ManifoldRepair, LeavesAManifoldAlone) {
  const HalfEdgeComplex tetrahedron{{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3},
                                    {9, 6, 3, 2, 8, 10, 1, 11, 4, 0, 5, 7},
                                    std::vector<Vec3>(4, Vec3::Zero())};
  expect_closed(tetrahedron);
  RepairCounts counts;
  const auto triangles =
      repair_half_edges(tetrahedron, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, RingChoice::Smooth, counts);
  EXPECT_EQ(triangles.size(), 4u);
  EXPECT_EQ(counts.total(), 0);
}

TEST(ManifoldRepair, RoughnessIsThePapersXi) {
  // A flat ring has none; a cube's corner has three right angles with normals 1/sqrt(3) off the mean.
  EXPECT_NEAR(ring_roughness({0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}), 0, 1e-12);
  const double each = 2 - 2 / std::sqrt(3.0);
  EXPECT_NEAR(ring_roughness({0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 3 * M_PI / 2 * each, 1e-12);
}

TEST(FilmStep, EveryStepFromTheSphereIsAManifold) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const SiteSet set = make_site_set(test::awkward(seed));
    if (set.size() < 4) continue;
    const PowerDiagram diagram = DelaunayTriangulation(set.perturbed).voronoi();
    Surface film = bounding_sphere(set.perturbed);
    for (int step = 0; step < 5 && !film.triangles.empty(); ++step) {
      RepairCounts counts;
      film = film_step(film, diagram, step % 2 ? RingChoice::Nearest : RingChoice::Smooth, counts);
      if (!film.triangles.empty()) expect_manifold(film);
    }
  }
}

TEST(Film, ReachesEverySiteOfASphereAndIsStable) {
  const SiteSet set = make_site_set(test::sphere(2000, 5));
  const PowerDiagram diagram = DelaunayTriangulation(set.perturbed).voronoi();
  FilmOptions options;
  std::vector<StepRecord> records;
  options.after_step = [&](const StepRecord& r, const Surface&) { return records.push_back(r), true; };
  const Surface film =
      evolve_film(bounding_sphere(set.perturbed), set.perturbed, set.size(), diagram, options);
  EXPECT_EQ(sites_on(film, set.size()), 2000);
  ASSERT_FALSE(records.empty());
  EXPECT_EQ(records.back().attracted, 2000);
  RepairCounts counts;
  EXPECT_EQ(connectivity_hash(film_step(film, diagram, RingChoice::Smooth, counts)), connectivity_hash(film));
}

// A sphere in a sphere, joined by nothing: plain steps stall on the outer one.
TEST(Film, WeightsAttractWhatAStalledFilmLeaves) {
  auto points = test::sphere(1500, 6);
  for (const Point& p : test::sphere(300, 7, {0, 0, 0}, 0.6)) points.push_back(p);
  const SiteSet set = make_site_set(points);
  const PowerDiagram diagram = DelaunayTriangulation(set.perturbed).voronoi();
  std::int64_t attracted[2];
  for (const bool weights : {false, true}) {
    FilmOptions options;
    options.weights = weights;
    attracted[weights] = sites_on(
        evolve_film(bounding_sphere(set.perturbed), set.perturbed, set.size(), diagram, options), set.size());
  }
  EXPECT_LT(attracted[0], 1800);
  EXPECT_GT(attracted[1], attracted[0]);
}

TEST(Film, VirtualSitesLeaveAndNeverStay) {
  const SiteSet set = make_site_set(test::sphere(800, 8));
  std::vector<Vec3> sites = set.perturbed;
  test::Random random(9);
  for (int i = 0; i < 60; ++i)
    sites.emplace_back(random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6));
  const PowerDiagram diagram = DelaunayTriangulation(set.perturbed).voronoi();
  FilmOptions options;
  std::int64_t left = 60;
  options.after_step = [&](const StepRecord& r, const Surface&) {
    EXPECT_LE(r.virtual_left, left);
    left = r.virtual_left;
    return true;
  };
  const Surface film = evolve_film(bounding_sphere(set.perturbed), sites, set.size(), diagram, options);
  expect_manifold(film);
  for (Index s : film.site) EXPECT_LT(s, static_cast<Index>(set.size()));
}

TEST(InsertSites, KeepsAManifoldAndReportsWhatWentIn) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const SiteSet set = make_site_set(test::torus(1500, seed));
    // A film of four sites in five; the fifth waits.
    std::vector<Vec3> some;
    std::vector<Index> off, id;
    for (std::size_t s = 0; s < set.size(); ++s) {
      if (s % 5 == seed % 5)
        off.push_back(static_cast<Index>(s));
      else
        some.push_back(set.perturbed[s]), id.push_back(static_cast<Index>(s));
    }
    const PowerDiagram diagram = DelaunayTriangulation(some).voronoi();
    Surface film = evolve_film(alpha_wrap(some, 0.1), some, some.size(), diagram, {});
    for (Index& s : film.site) s = id[s];
    const std::size_t before = film.site.size();
    const std::int64_t inserted = insert_sites(film, set.perturbed, off, 2);
    EXPECT_EQ(film.site.size(), before + static_cast<std::size_t>(inserted));
    EXPECT_GT(inserted, static_cast<std::int64_t>(off.size()) * 9 / 10);
    expect_manifold(film);
  }
}

}  // namespace
}  // namespace filmsticking
