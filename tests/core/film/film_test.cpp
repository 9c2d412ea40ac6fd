// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/film.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "film/initial_surface.h"
#include "points/site_set.h"
#include "support/clouds.h"
#include "support/film_check.h"

namespace filmsticking {
namespace {

TEST(FilmStep, EveryStepFromTheSphereIsAManifold) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const SiteSet set = make_site_set(test::awkward(seed));
    if (set.size() < 4) continue;
    const PowerDiagram diagram = DelaunayTriangulation(set.perturbed).voronoi();
    Surface film = bounding_sphere(set.perturbed);
    for (int step = 0; step < 5 && !film.triangles.empty(); ++step) {
      RepairCounts counts;
      film = film_step(film, diagram, step % 2 ? RingChoice::Nearest : RingChoice::Smooth, counts);
      if (!film.triangles.empty()) test::expect_manifold(film);
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

// A sphere in a sphere, unconnected: plain steps stall on the outer one.
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
  test::expect_manifold(film);
  for (Index s : film.site) EXPECT_LT(s, static_cast<Index>(set.size()));
}

TEST(Film, StopsWhereTheCallerSaysSo) {
  const SiteSet set = make_site_set(test::sphere(500, 5));
  const PowerDiagram diagram = DelaunayTriangulation(set.perturbed).voronoi();
  FilmOptions options;
  int steps = 0;
  options.after_step = [&](const StepRecord&, const Surface&) { return ++steps < 2; };
  evolve_film(bounding_sphere(set.perturbed), set.perturbed, set.size(), diagram, options);
  EXPECT_EQ(steps, 2);
}

}  // namespace
}  // namespace filmsticking
