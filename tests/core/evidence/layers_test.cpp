// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/layers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "evidence/depth_image.h"
#include "support/depth_images.h"

namespace filmsticking {
namespace {

// A wavy sheet with noise (in spacings) is one layer; a sheet that is doubled in a part of its area is not.
TEST(Layers, AreNotConfusedWithNoise) {
  constexpr int kPoints = 4000;
  const double spacing = 2 / std::sqrt(kPoints);
  const auto share = [&](double noise, double apart, double of_area, std::uint64_t seed) {
    test::Random random(seed);
    std::vector<Vec3> places;
    for (int i = 0; i < kPoints; ++i) {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      const bool behind = x > 1 - 2 * of_area && random.below(2) == 0;
      places.emplace_back(x, y, 6 + 0.2 * std::sin(3 * x) * std::cos(2 * y) + (behind ? apart * spacing : 0));
    }
    places = test::noisy(places, noise * spacing, random);
    const SiteGeometry geometry = site_geometry(places);
    return share_between_layers(depth_image_surface(places, Vec3::Zero(), geometry), places, geometry);
  };
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const double noise : {0.0, 0.1, 0.25, 0.5}) EXPECT_LE(share(noise, 0, 0, seed), 0.04) << noise;
    for (const double apart : {0.75, 1.5, 3.0, 5.0}) {
      EXPECT_GE(share(0, apart, 1, seed), 0.15) << apart;
      EXPECT_GE(share(0, apart, 0.5, seed), 0.07) << apart;
    }
  }
  EXPECT_EQ(share_between_layers({}, {}, {}), 0);
}

}  // namespace
}  // namespace filmsticking
