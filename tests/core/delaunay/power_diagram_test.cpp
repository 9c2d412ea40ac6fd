// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/power_diagram.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/clouds.h"
#include "support/power_cells.h"

namespace filmsticking {
namespace {

TEST(PowerDiagram, OwnerIsTheNearestSiteFromAnyHint) {
  const PowerDiagram diagram = DelaunayTriangulation(test::random_sites(300, 1)).voronoi();
  const std::vector<char> all(300, 1);
  test::Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Vec3 x(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
    EXPECT_EQ(diagram.owner(x, random.below(300)), test::brute_owner(diagram, x, all));
  }
}

TEST(PowerDiagram, WeightsHideAndAbsentSitesHaveNoCell) {
  const auto sites = test::random_sites(200, 3);
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
    EXPECT_EQ(diagram.owner(x, kNone), test::brute_owner(diagram, x, present));
  }
}

TEST(PowerDiagram, SitesCanLeave) {
  DelaunayTriangulation triangulation(test::random_sites(100, 5));
  std::vector<char> present(100, 1);
  for (int i = 0; i < 100; i += 3) triangulation.remove(i), present[i] = 0;
  triangulation.remove(0);  // again: nothing happens
  const PowerDiagram diagram = triangulation.voronoi();
  test::Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Vec3 x(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    EXPECT_EQ(diagram.owner(x, 0), test::brute_owner(diagram, x, present));
  }
}

}  // namespace
}  // namespace filmsticking
