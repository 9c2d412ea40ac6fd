// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "delaunay/delaunay.h"
#include "film/film_step.h"
#include "filmsticking/reconstruct.h"
#include "support/clouds.h"
#include "support/power_cells.h"

namespace filmsticking {
namespace {

// By the step itself: of random labels, and of what steps without memory leave.
TEST(Stability, IsTheShareOfFacetsWhoseTetrahedraAStepKeeps) {
  const std::vector<Vec3> sites = test::random_sites(300, 7);
  const TetrahedralMesh mesh = make_tetrahedral_mesh(delaunay_tetrahedra(sites, {}), sites);
  LabelledFilm film{std::make_shared<const PowerComplex>(sites, mesh.tets), {}};
  test::Random random(8);
  for (std::size_t t = 0; t < mesh.size(); ++t)
    film.inside.push_back(
        static_cast<char>(!mesh.tets.infinite(static_cast<Index>(t)) && random.below(2) == 1));
  for (int round = 0; round < 3; ++round) {
    const std::vector<float> shares = site_stability(mesh, sites, film.inside);
    std::int64_t held = 0;
    const LabelledFilm next =
        film_step(film, film.complex, std::vector<double>(sites.size(), 1), false, held);
    std::vector<int> facets(sites.size(), 0), kept(sites.size(), 0);
    for (std::size_t t = 0; t < mesh.size(); ++t)
      for (int k = 0; k < 4; ++k) {
        const Index u = mesh.tets.neighbours[t][k];
        if (!film.inside[t] || film.inside[u]) continue;
        for (const int i : kFacet[k]) {
          ++facets[mesh.tets.corners[t][i]];
          if (next.inside[t] && !next.inside[u]) ++kept[mesh.tets.corners[t][i]];
        }
      }
    for (std::size_t v = 0; v < sites.size(); ++v) {
      const float share = facets[v] > 0 ? static_cast<float>(kept[v]) / static_cast<float>(facets[v]) : 1;
      EXPECT_EQ(shares[v], share);
    }
    film = next;
  }
}

// A dense sphere is stable nearly everywhere; a wall half a spacing thick is not.
TEST(Stability, IsHighOnASphereAndLowInAThinWall) {
  Options options;
  EXPECT_TRUE(reconstruct(test::sphere(3000, 1), options).stability.empty());
  options.stability = true;
  EXPECT_GT(reconstruct(test::sphere(3000, 1), options).report.stability, 0.9);
  std::vector<Point> wall;
  test::Random random(9);
  for (int i = 0; i < 3000; ++i)
    wall.push_back({random.uniform(0, 1), random.uniform(0, 1), i % 2 == 0 ? 0.0 : 0.01});
  const Result result = reconstruct(wall, options);
  ASSERT_EQ(result.status, Status::Ok);
  EXPECT_LT(result.report.stability, 0.7);
}

}  // namespace
}  // namespace filmsticking
