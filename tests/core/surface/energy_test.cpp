// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/energy.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

SurfaceQuality plain(double area) {
  SurfaceQuality quality;
  quality.area = area;
  quality.complexity = 1;
  quality.conflict = 0;
  return quality;
}

TEST(Energy, OfNothingIsTheWorst) {
  EXPECT_EQ(surface_energy({}, 0, 100), std::numeric_limits<double>::infinity());
}

TEST(Energy, EveryTermRaisesItByItsPrice) {
  const EnergyPrices prices;
  const double base = surface_energy(plain(100), 0, 100);
  EXPECT_NEAR(base, 1 + prices.off * prices.complexity / 100, 1e-12);
  const auto more = [&](auto change, std::int64_t inserted = 0) {
    SurfaceQuality quality = plain(100);
    change(quality);
    return 100 * (surface_energy(quality, inserted, 100) - base);
  };
  EXPECT_NEAR(more([](auto& q) { q.area += 3; }), 3, 1e-9);
  EXPECT_NEAR(more([](auto& q) { q.roughness += 2; }), 2, 1e-9);
  EXPECT_NEAR(more([](auto& q) { q.off += 4; }), 4 * prices.off, 1e-9);
  EXPECT_NEAR(more([](auto&) {}, 5), 5 * prices.off * prices.inserted, 1e-9);
  EXPECT_NEAR(more([](auto& q) { ++q.complexity; }), prices.off * prices.complexity, 1e-9);
  EXPECT_NEAR(more([](auto& q) { q.conflict += 0.25; }), 25 * prices.conflict, 1e-9);
}

// The reason for areas: half a ball, closed flat, against its skin doubled.
TEST(Energy, ASolidWithALidCostsLessThanADoubleSkin) {
  const Surface ball = test::ball();
  SiteGeometry geometry = site_geometry(ball.positions);
  const SurfaceQuality once = surface_quality(ball, geometry);
  SurfaceQuality lid = once, twice = once;
  lid.area *= 1.5;  // a disc is half the area of its half ball
  twice.area *= 2, twice.roughness *= 2;
  EXPECT_LT(surface_energy(lid, 0, ball.positions.size()), surface_energy(twice, 0, ball.positions.size()));
}

}  // namespace
}  // namespace filmsticking
