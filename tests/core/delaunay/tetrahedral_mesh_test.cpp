// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/tetrahedral_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "geometry/triangle_adjacency.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(TetrahedralMesh, FacetsFaceOutAndMirrorsMatch) {
  const Setting s(test::sphere(300, 1));
  for (std::size_t t = 0; t < s.mesh.size(); ++t)
    for (int k = 0; k < 4; ++k) {
      const Index mirror = s.mesh.mirror[t][k];
      EXPECT_EQ(s.mesh.mirror[mirror / 4][mirror % 4], static_cast<Index>(4 * t) + k);
      if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
      const auto& c = s.mesh.tets.corners[t];
      const Vec3 &a = s.set.perturbed[c[kFacet[k][0]]], &b = s.set.perturbed[c[kFacet[k][1]]],
                 &d = s.set.perturbed[c[kFacet[k][2]]];
      EXPECT_GT((b - a).cross(d - a).dot(a - s.set.perturbed[c[k]]), 0);
      EXPECT_NEAR((s.mesh.circumcentre[t] - s.set.perturbed[c[k]]).norm() / s.mesh.circumradius[t], 1, 1e-6);
    }
}

TEST(TetrahedralMesh, OfAnInfiniteTetrahedronTheCircumcentreIsTheNormalIntoTheHull) {
  const Setting s(test::sphere(300, 1));
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (!s.mesh.tets.infinite(static_cast<Index>(t))) continue;
    EXPECT_NEAR(s.mesh.circumcentre[t].norm(), 1, 1e-12);
    EXPECT_TRUE(std::isinf(s.mesh.circumradius[t]));
    EXPECT_EQ(s.mesh.flat[t], 0);
    for (const Index v : s.mesh.tets.corners[t])
      if (v != kNone) {
        EXPECT_LT(s.mesh.circumcentre[t].dot(s.set.perturbed[v]), 0);
      }
  }
}

TEST(TetrahedralMesh, BoundaryOfAllFiniteTetrahedraIsTheHull) {
  const Setting s(test::ellipsoid(500, 2, 0));
  std::vector<char> inside(s.mesh.size());
  std::size_t infinite = 0;
  for (std::size_t t = 0; t < inside.size(); ++t) {
    inside[t] = !s.mesh.tets.infinite(static_cast<Index>(t));
    infinite += !inside[t];
  }
  const std::vector<Corners> hull = tetrahedral_boundary(s.mesh, inside);
  EXPECT_EQ(hull.size(), infinite);
  EXPECT_TRUE(check_manifold(hull, static_cast<Index>(s.set.size())).ok());
  for (const Corners& t : hull) {
    const Vec3 &a = s.set.perturbed[t[0]], &b = s.set.perturbed[t[1]], &c = s.set.perturbed[t[2]];
    for (const Vec3& p : s.set.perturbed) EXPECT_LE((b - a).cross(c - a).dot(p - a), 1e-12);
  }
}

TEST(TetrahedralMesh, BoundaryHasTwoSidesWhicheverTetrahedraAreInside) {
  const Setting s(test::torus(300, 3));
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const std::vector<char> inside = test::random_labels(s.mesh, seed);
    // Every edge of the boundary has as many facets along it as against it.
    std::map<std::pair<Index, Index>, int> along;
    for (const Corners& t : tetrahedral_boundary(s.mesh, inside))
      for (int k = 0; k < 3; ++k) ++along[{t[k], t[(k + 1) % 3]}], --along[{t[(k + 1) % 3], t[k]}];
    for (const auto& [edge, count] : along) EXPECT_EQ(count, 0);
  }
}

TEST(TetrahedralMesh, FacetsOfAFlatTetrahedronAreOnTwoSides) {
  const Setting s(test::grid(5));
  int flat = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.mesh.flat[t] == 0) continue;
    ++flat;
    EXPECT_LT(s.mesh.flat[t], 15);  // some facets are on each side
    const auto& c = s.mesh.tets.corners[t];
    const Vec3 &a = s.set.perturbed[c[0]], &b = s.set.perturbed[c[1]], &d = s.set.perturbed[c[2]],
               &e = s.set.perturbed[c[3]];
    EXPECT_LT(std::abs((b - a).cross(d - a).dot(e - a)), 1e-6);
  }
  EXPECT_GT(flat, 0);
}

}  // namespace
}  // namespace filmsticking
