// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/regular.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "delaunay/canonical_order.h"
#include "delaunay/delaunay.h"
#include "support/power_cells.h"

namespace filmsticking {
namespace {

TEST(Regular, WithoutWeightsItIsDelaunay) {
  const std::vector<Vec3> sites = test::random_sites(400, 1);
  const Tetrahedra expected = delaunay_tetrahedra(sites);
  for (const std::vector<double>& weights : {std::vector<double>{}, std::vector<double>(400, 0.25)}) {
    const Tetrahedra tets = in_canonical_order(regular_tetrahedra(sites, weights), sites.size());
    EXPECT_TRUE(tets.corners == expected.corners);
    EXPECT_TRUE(tets.neighbours == expected.neighbours);
  }
}

TEST(Regular, ASiteThatAnotherHidesHasNoTetrahedron) {
  std::vector<Vec3> sites = test::random_sites(100, 2);
  sites.push_back(sites[7] + Vec3(1e-3, 0, 0));
  std::vector<double> weights(sites.size(), 0);
  weights[7] = 0.1;
  for (const auto& corners : regular_tetrahedra(sites, weights).corners)
    for (const Index v : corners) EXPECT_NE(v, 100);
}

TEST(Regular, KeepsItsLimitsAndIsEmptyOnAPlane) {
  const std::vector<Vec3> sites = test::random_sites(2000, 3);
  const std::vector<double> weights(sites.size(), 0.5);
  TriangulationLimits few;
  few.tetrahedra = 1000;
  EXPECT_THROW(regular_tetrahedra(sites, weights, few), TooManyTetrahedra);
  const std::atomic<bool> stop{true};
  TriangulationLimits cancelled;
  cancelled.cancel = {&stop};
  EXPECT_THROW(regular_tetrahedra(sites, {}, cancelled), Cancelled);
  std::vector<Vec3> flat = sites;
  for (Vec3& p : flat) p.z() = 0;
  EXPECT_EQ(regular_tetrahedra(flat, weights).size(), 0u);
}

}  // namespace
}  // namespace filmsticking
