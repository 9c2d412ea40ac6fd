// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_normals.h"

#include <gtest/gtest.h>

#include <vector>

#include "film/initial_surface.h"
#include "points/site_set.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

TEST(SurfaceNormals, AreOutwardAndLeaveOtherSitesAlone) {
  Surface sphere = bounding_sphere(make_site_set(test::grid(2)).perturbed);
  const std::size_t n = sphere.positions.size();
  for (std::size_t v = 0; v < n; ++v) sphere.site[v] = static_cast<Index>(v + 1);  // site 0 is off it
  const Vec3 otherwise(0, 0.6, -0.8);
  const std::vector<Vec3> normals = surface_normals(sphere, std::vector<Vec3>(n + 1, otherwise));
  EXPECT_EQ(normals[0], otherwise);
  for (std::size_t v = 0; v < n; ++v) {
    EXPECT_NEAR(normals[v + 1].norm(), 1, 1e-12);
    EXPECT_GT(normals[v + 1].dot(sphere.positions[v].normalized()), 0.999);
  }
  for (Vec3& p : sphere.positions) p = {p.x(), 0, 0};  // flat: there is no normal
  for (const Vec3& normal : surface_normals(sphere, std::vector<Vec3>(n + 1, otherwise)))
    EXPECT_EQ(normal, otherwise);
}

}  // namespace
}  // namespace filmsticking
