// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/insert_sites.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "film/film.h"
#include "film/initial_surface.h"
#include "points/site_set.h"
#include "support/clouds.h"
#include "support/film_check.h"

namespace filmsticking {
namespace {

TEST(InsertSites, KeepsAManifoldAndReportsWhatWentIn) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const SiteSet set = make_site_set(test::torus(1500, seed));
    // A film of four sites in five, the others off it.
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
    test::expect_manifold(film);
  }
}

TEST(InsertSites, ASiteFarFromEveryFaceStaysOff) {
  const SiteSet set = make_site_set(test::sphere(500, 3));
  const PowerDiagram diagram = DelaunayTriangulation(set.perturbed).voronoi();
  Surface film = evolve_film(bounding_sphere(set.perturbed), set.perturbed, set.size(), diagram, {});
  std::vector<Vec3> sites = set.perturbed;
  sites.emplace_back(9, 9, 9);
  const std::vector<Corners> before = film.triangles;
  EXPECT_EQ(insert_sites(film, sites, {static_cast<Index>(set.size())}, 2), 0);
  EXPECT_EQ(film.triangles, before);
}

}  // namespace
}  // namespace filmsticking
