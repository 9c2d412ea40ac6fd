// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/initial_surface.h"

#include <gtest/gtest.h>

#include <vector>

#include "geometry/triangle_adjacency.h"
#include "points/site_set.h"
#include "support/clouds.h"
#include "support/surfaces.h"
#include "surface/orientation.h"

namespace filmsticking {
namespace {

TEST(InitialSurface, SphereHoldsTheSites) {
  const SiteSet set = make_site_set(test::grid(4));
  const Surface sphere = bounding_sphere(set.perturbed);
  EXPECT_TRUE(check_manifold(sphere.triangles, static_cast<Index>(sphere.positions.size())).ok());
  EXPECT_GT(test::signed_volume6(sphere), 0);
  for (const Corners& t : sphere.triangles) {
    const Vec3 &a = sphere.positions[t[0]], &b = sphere.positions[t[1]], &c = sphere.positions[t[2]];
    const Vec3 outward = (b - a).cross(c - a);
    for (const Vec3& p : set.perturbed) EXPECT_LT(outward.dot(p - a), 0);
  }
}

TEST(InitialSurface, WrapIsClosedAndHoldsTheSites) {
  const SiteSet set = make_site_set(test::torus(3000, 3));
  const Surface wrap = alpha_wrap(set.perturbed, 0.1);
  EXPECT_TRUE(check_manifold(wrap.triangles, static_cast<Index>(wrap.positions.size())).ok());
  std::vector<Index> all;
  for (std::size_t t = 0; t < wrap.triangles.size(); ++t) all.push_back(static_cast<Index>(t));
  for (std::size_t s = 0; s < set.size(); s += 50)
    EXPECT_NEAR(solid_angle_winding(wrap, all, set.perturbed[s]), 1, 1e-6);
}

}  // namespace
}  // namespace filmsticking
