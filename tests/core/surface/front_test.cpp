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
  const SurfaceTopology topology(surface.triangles, static_cast<Index>(surface.positions.size()));
  return turn_to_sensors(surface, topology.component, viewpoints);
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

TEST(Front, AClosedComponentShowsItToWhatStandsInsideOrOutside) {
  for (const double distance : {0.0, 10.0}) {
    Surface ball = own_sites(test::ball());
    std::vector<Vec3> seen_from(ball.positions.size());
    for (std::size_t v = 0; v < seen_from.size(); ++v) seen_from[v] = distance * ball.positions[v];
    EXPECT_EQ(turn(ball, seen_from), distance == 0);
  }
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
