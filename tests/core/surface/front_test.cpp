// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/front.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

double facing(const Surface& surface, const Vec3& sensor) {
  double front = 0, all = 0;
  for (Index t = 0; t < static_cast<Index>(surface.triangles.size()); ++t) {
    const Vec3 area = surface.area_vector2(t);
    all += area.norm();
    if (area.dot(sensor - test::middle(surface, t)) > 0) front += area.norm();
  }
  return front / all;
}

Surface own_sites(Surface surface) {
  for (std::size_t v = 0; v < surface.site.size(); ++v) surface.site[v] = static_cast<Index>(v);
  return surface;
}

Index turn(Surface& surface, const std::vector<Vec3>& viewpoints) {
  return turn_to_sensors(
      surface, SurfaceTopology(surface.triangles, static_cast<Index>(surface.positions.size())), viewpoints);
}

TEST(Front, ASheetShowsItToItsSensorWhicheverWayItWasTurned) {
  for (const double side : {-1.0, 1.0}) {
    Surface sheet = own_sites(test::square_sheet(8, 1));
    const Vec3 sensor(0.5, 0.5, side);
    const std::vector<Vec3> viewpoints(sheet.positions.size(), sensor);
    turn(sheet, viewpoints);
    EXPECT_EQ(facing(sheet, sensor), 1);
    EXPECT_EQ(turn(sheet, viewpoints), 0);  // a second time there is nothing to turn
  }
}

TEST(Front, AClosedComponentKeepsItsOutside) {
  Surface ball = own_sites(test::ball());
  const auto before = ball.triangles;
  EXPECT_EQ(turn(ball, std::vector<Vec3>(ball.positions.size(), Vec3::Zero())), 0);
  EXPECT_EQ(ball.triangles, before);
}

TEST(Front, UnknownSensorsTurnNothing) {
  Surface sheet = own_sites(test::square_sheet(8, 1));
  const auto before = sheet.triangles;
  const Vec3 unknown = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(turn(sheet, std::vector<Vec3>(sheet.positions.size(), unknown)), 0);
  EXPECT_EQ(sheet.triangles, before);
}

}  // namespace
}  // namespace filmsticking
