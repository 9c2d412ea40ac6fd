// SPDX-License-Identifier: GPL-3.0-or-later
// The field methods on the Delaunay tetrahedra.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "evidence/ball.h"
#include "evidence/signed_field.h"
#include "film/film.h"
#include "film/poisson.h"
#include "film/winding_number.h"
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

TEST(WindingNumber, IsOneInsideAndNoneOutside) {
  const Setting s(test::sphere(3000, 2));
  std::vector<Vec3> dipoles;
  for (const Vec3& p : s.set.perturbed) dipoles.push_back(p.normalized() * (M_PI / 3000));
  const WindingNumber winding(s.set.perturbed, dipoles);
  test::Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Point d = random.direction();
    const Vec3 v(d[0], d[1], d[2]);
    for (const double radius : {0.4 * random.uniform(), 0.6 + random.uniform()}) {
      const Vec3 x = radius * v;
      double direct = 0;  // without grouping; the samples' own unevenness is in both
      for (std::size_t k = 0; k < dipoles.size(); ++k) {
        const Vec3 to = s.set.perturbed[k] - x;
        direct += dipoles[k].dot(to) / (4 * M_PI * std::pow(to.norm(), 3));
      }
      EXPECT_NEAR(winding(x), direct, 0.04);  // a group is one dipole from 2.3 radii on
      EXPECT_NEAR(winding(x), radius < 0.5 ? 1 : 0, 0.15);
    }
  }
}

TEST(WindingNumber, PlatesLeaveNoTrace) {
  // Two layers over the same sites: the vectors cancel.
  Surface plate;
  plate.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  plate.site = {0, 1, 2, 3};
  plate.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 2, 1}, {1, 2, 3}};
  for (const Vec3& d : film_dipoles(plate, 4)) EXPECT_EQ(d.norm(), 0);
}

TEST(Carve, ReachesTheOutsideAndNoSolid) {
  const Setting s(test::torus(4000, 4));
  const auto width = carve_widths(s.mesh, s.set.perturbed, s.geometry.spacing, 0, 1e9);
  int wrong = 0, deep = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
    const Point x = s.set.to_input(s.mesh.circumcentre[t]);
    const double off = std::hypot(std::hypot(x[0], x[1]) - 1, x[2]) - 0.4;
    if (std::abs(off) < 0.15) continue;  // near the surface both are right
    ++deep;
    wrong += (off < 0) != (width[t] < 2.5);
  }
  EXPECT_GT(deep, 100);
  EXPECT_LT(wrong, deep / 100);
}

TEST(SignedField, KnowsNestedSpheresByParity) {
  auto points = test::sphere(6000, 5);
  for (const Point& p : test::sphere(1500, 6, {0, 0, 0}, 0.5)) points.push_back(p);
  const Setting s(points);
  const auto field = signed_field(s.mesh, s.evidence, std::vector<double>(s.mesh.size(), 0));
  int right = 0, all = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
    const double r = s.centre(t).norm() * 2;
    if (std::abs(r - 1) < 0.1 || std::abs(r - 0.5) < 0.1) continue;
    ++all;
    right += (field[t] > 0) == (r < 1 && r > 0.5);
  }
  EXPECT_GT(right, all * 99 / 100);
}

TEST(Poisson, SeparatesInsideFromOutside) {
  const Setting s(test::sphere(2000, 8));
  std::vector<Vec3> normals;
  for (const Vec3& p : s.set.perturbed) normals.push_back(p.normalized());
  const auto belief = poisson_belief(s.mesh, s.set.perturbed, normals);
  ASSERT_EQ(belief.size(), s.mesh.size());
  int right = 0, all = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t)) || std::abs(s.centre(t).norm() - 0.5) < 0.03) continue;
    ++all;
    right += (belief[t] > 0) == (s.centre(t).norm() < 0.5);
  }
  EXPECT_GT(right, all * 99 / 100);
  EXPECT_TRUE(poisson_belief(s.mesh, s.set.perturbed, std::vector<Vec3>(s.set.size(), Vec3::Zero())).empty());
}

}  // namespace
}  // namespace filmsticking
