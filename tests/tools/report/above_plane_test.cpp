// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/above_plane.h"

#include <gtest/gtest.h>

#include "report/extent.h"
#include "report/report.h"
#include "support/shapes.h"

namespace filmsticking::mesh_report {
namespace {

using test::Model;
using test::plane;
using test::torus;

TEST(PlaneVolumes, AreOnBothSidesOfThePlane) {
  for (const double scale : {1.0, 1e-9, 1e7}) {
    const Vec3 up = Vec3(1, 2, -2) / 3;
    Model mesh = torus({0, 0, 0}, 200);
    for (Point& p : mesh.positions)
      for (double& x : p) x *= scale;
    const Surface surface = make_surface(mesh);
    const double volume = extent(surface).signed_volume;
    const PlaneVolumes half = plane_volumes(surface, up, 0);  // through the middle
    EXPECT_NEAR(half.above / volume, 0.5, 1e-3);
    EXPECT_NEAR((half.above + half.below) / volume, 1, 1e-9);
    EXPECT_NEAR(half.net / volume, 1, 1e-9);
    const PlaneVolumes all = plane_volumes(surface, up, 9 * scale);
    EXPECT_NEAR(all.above / volume, 1, 1e-9);
    EXPECT_EQ(all.below, 0);
  }
}

TEST(PlaneVolumes, OfAnOpenSurfaceAreFillAndCut) {
  // A square 2 x 2 that leans from -1 to 1: a wedge above, the same below.
  const Surface roof = make_surface(plane({0, 0, -1}, {2, 0, 2}, {0, 2, 0}, 3));
  const PlaneVolumes volumes = plane_volumes(roof, Vec3::UnitZ(), 0);
  EXPECT_NEAR(volumes.above, 1, 1e-12);
  EXPECT_NEAR(volumes.below, 1, 1e-12);
  EXPECT_NEAR(volumes.net, 0, 1e-12);
  const PlaneVolumes high = plane_volumes(roof, Vec3::UnitZ(), 5);
  EXPECT_NEAR(high.above, 20, 1e-12);
}

}  // namespace
}  // namespace filmsticking::mesh_report
