// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/winding_number.h"

#include <gtest/gtest.h>

#include <cmath>

#include "film/initial_surface.h"
#include "points/site_set.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

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
  for (const Vec3& d : film_dipoles(plate, {1, 1, 1, 1})) EXPECT_EQ(d.norm(), 0);
}

// A wide face beside narrow ones at a right angle, as where a plate dangles from a body.
TEST(WindingNumber, WideFacesDoNotOwnTheNormalsOfTheirRim) {
  Surface rim;
  rim.positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 5}, {0, 5, 5}};
  rim.site = {0, 1, 2, 3, 4};
  rim.triangles = {{0, 1, 2}, {0, 4, 3}};
  const Vec3 dipole = film_dipoles(rim, {0.1, 0.1, 0.1, 0.1, 0.1})[0];
  EXPECT_GT(dipole.normalized().z(), 0.99);
  EXPECT_NEAR(dipole.norm(), 0.01, 1e-9);
}

TEST(SurfaceWinding, IsOneWithinAClosedSurfaceAndNoneOutside) {
  const SiteSet set = make_site_set(test::sphere(300, 4));
  const Surface sphere = bounding_sphere(set.perturbed);
  const SurfaceWinding winding(sphere);
  test::Random random(5);
  const double radius = sphere.positions[0].norm();
  for (int i = 0; i < 300; ++i) {
    const Point d = random.direction();
    const Vec3 v(d[0], d[1], d[2]);
    EXPECT_NEAR(winding(random.uniform(0, 0.98) * radius * v), 1, 0.1);
    EXPECT_NEAR(winding(random.uniform(1.02, 4) * radius * v), 0, 0.1);
  }
  EXPECT_EQ(SurfaceWinding({})(Vec3(0, 0, 0)), 0);
}

}  // namespace
}  // namespace filmsticking
