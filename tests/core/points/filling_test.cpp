// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/filling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "points/site_set.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

bool fills(const std::vector<Point>& points) {
  const SiteSet sites = make_site_set(points);
  return fills_volume(sites.perturbed, site_geometry(sites.perturbed));
}

std::vector<Point> random_box(int n, std::uint64_t seed, const Point& size) {
  test::Random random(seed);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i)
    points.push_back({random.uniform(0, size[0]), random.uniform(0, size[1]), random.uniform(0, size[2])});
  return points;
}

TEST(Filling, OfGridsAndRandomPointsInASolid) {
  EXPECT_TRUE(fills(test::grid(10)));
  std::vector<Point> brick;  // nodes of 10 x 10 x 60 elements
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 10; ++j)
      for (int k = 0; k <= 60; ++k) brick.push_back({double(i), double(j), double(k)});
  EXPECT_TRUE(fills(brick));
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_TRUE(fills(random_box(5000, seed, {1, 1, 1})));
    EXPECT_TRUE(fills(random_box(5000, seed, {1, 1, 3})));
  }
}

TEST(Filling, SurfacesDoNotWithNoiseOrThinWallsEither) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_FALSE(fills(test::sphere(3000, seed)));
    EXPECT_FALSE(fills(test::torus(3000, seed)));
    for (const double spacings : {0.5, 1.0, 2.0})
      EXPECT_FALSE(fills(test::box(3000, seed, {1, 1, spacings * std::sqrt(2.0 / 3000)}))) << spacings;
    test::Random random(seed);
    auto noisy = test::sphere(3000, seed);
    const double noise = 0.5 * std::sqrt(4 * M_PI / 3000);
    for (Point& p : noisy)
      for (double& x : p)
        x += noise * (random.uniform(-1, 1) + random.uniform(-1, 1) + random.uniform(-1, 1));
    EXPECT_FALSE(fills(noisy));
  }
  EXPECT_FALSE(fills(test::read_float_ply(TEST_DATA "/spot_10k.ply")));
}

TEST(Filling, FewPointsFillNothing) { EXPECT_FALSE(fills(test::grid(5))); }

}  // namespace
}  // namespace filmsticking
