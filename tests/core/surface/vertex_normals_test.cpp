// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/vertex_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "film/initial_surface.h"
#include "points/site_set.h"
#include "support/surfaces.h"

namespace filmsticking {
namespace {

Surface ball() { return bounding_sphere(make_site_set(test::grid(2)).perturbed); }

// The least cosine between the normals and the directions from the middle.
double worst(const std::vector<Vec3>& normals, const Surface& directions) {
  double least = 1;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    EXPECT_NEAR(normals[v].norm(), 1, 1e-12);
    least = std::min(least, normals[v].dot(directions.positions[v].normalized()));
  }
  return least;
}

TEST(VertexNormals, PointOutwardOnASmoothSurface) { EXPECT_GT(worst(vertex_normals(ball()), ball()), 0.999); }

TEST(VertexNormals, PointOutwardOnARoughSurface) {
  const Surface smooth = ball();
  const double deviation = 0.6 * test::spacing(smooth);
  Surface rough = smooth;
  test::Random random(5);
  for (Vec3& p : rough.positions)
    for (int k = 0; k < 3; ++k) p[k] += random.uniform(-deviation, deviation);
  EXPECT_GT(worst(vertex_normals(rough), smooth), 0.5);
}

TEST(VertexNormals, AreUnitOnASurfaceWithoutArea) {
  Surface flat = test::surface_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, test::kTetrahedron);
  for (const Vec3& normal : vertex_normals(flat)) EXPECT_NEAR(normal.norm(), 1, 1e-12);
  for (Vec3& p : flat.positions) p.setZero();
  for (const Vec3& normal : vertex_normals(flat)) EXPECT_NEAR(normal.norm(), 1, 1e-12);
}

TEST(VertexNormals, StopWhenAsked) {
  const std::atomic<bool> stop{true};
  EXPECT_THROW(vertex_normals(ball(), {&stop}), Cancelled);
}

}  // namespace
}  // namespace filmsticking
