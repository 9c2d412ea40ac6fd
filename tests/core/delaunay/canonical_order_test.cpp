// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/canonical_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "delaunay/delaunay.h"
#include "delaunay/regular.h"
#include "support/power_cells.h"

namespace filmsticking {
namespace {

TEST(CanonicalOrder, ForgetsTheOrder) {
  const std::vector<Vec3> sites = test::random_sites(500, 3);
  const Tetrahedra canonical = delaunay_tetrahedra(sites);
  Tetrahedra shuffled;
  const auto n = static_cast<Index>(canonical.size());
  std::vector<Index> place(canonical.size());
  for (Index t = 0; t < n; ++t) place[t] = n - 1 - t;
  shuffled.corners.resize(canonical.size()), shuffled.neighbours.resize(canonical.size());
  for (Index t = 0; t < n; ++t)
    for (int k = 0; k < 4; ++k) {
      const int turned = t % 3 == 0 || k == 3 ? k : (k + t % 3) % 3;  // three corners around the fourth
      shuffled.corners[place[t]][turned] = canonical.corners[t][k];
      shuffled.neighbours[place[t]][turned] = place[canonical.neighbours[t][k]];
    }
  const Tetrahedra sorted = in_canonical_order(shuffled, sites.size());
  EXPECT_TRUE(sorted.corners == canonical.corners);
  EXPECT_TRUE(sorted.neighbours == canonical.neighbours);
}

TEST(CanonicalOrder, KeepsOrientationAndNeighbours) {
  const std::vector<Vec3> sites = test::random_sites(300, 4);
  const Tetrahedra tets = in_canonical_order(regular_tetrahedra(sites, {}), sites.size());
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const auto& c = tets.corners[t];
    EXPECT_LT(static_cast<std::uint32_t>(c[0]), static_cast<std::uint32_t>(c[1]));
    for (int k = 0; k < 4; ++k) {
      // The neighbour across the facet opposite corner k has the three other corners.
      const auto& other = tets.corners[tets.neighbours[t][k]];
      for (int j = 0; j < 4; ++j)
        if (j != k) {
          EXPECT_NE(std::find(other.begin(), other.end(), c[j]), other.end());
        }
    }
    if (tets.infinite(static_cast<Index>(t))) continue;
    const Vec3& a = sites[c[0]];
    EXPECT_GT((sites[c[1]] - a).cross(sites[c[2]] - a).dot(sites[c[3]] - a), 0);
  }
}

}  // namespace
}  // namespace filmsticking
