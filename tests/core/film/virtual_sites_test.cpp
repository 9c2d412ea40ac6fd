// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/virtual_sites.h"

#include <gtest/gtest.h>

#include <cmath>

#include "delaunay/delaunay.h"
#include "geometry/nearest.h"
#include "points/site_set.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

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
