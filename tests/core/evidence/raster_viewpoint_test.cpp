// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/raster_viewpoint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/clouds.h"
#include "support/depth_images.h"

namespace filmsticking {
namespace {

TEST(RasterViewpoint, IsWhereTheRowsMeet) {
  for (const auto& [name, depth] : test::kScenes)
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(seed));
      test::Random random(seed);
      std::vector<Vec3> pixels = test::image_of(depth, 80);
      // Some pixels are missing in every image.
      pixels.erase(
          std::remove_if(pixels.begin(), pixels.end(), [&](const Vec3&) { return random.uniform() < 0.1; }),
          pixels.end());
      Vec3 viewpoint;
      const auto places = test::in_unit_box(pixels, test::random_pose(random), viewpoint);
      const auto found = raster_viewpoint(places, site_geometry(places));
      ASSERT_TRUE(found);
      EXPECT_LT((*found - viewpoint).norm(), 0.02);
    }
}

TEST(RasterViewpoint, OfNoRasterIsNothing) {
  const auto found = [](const std::vector<Vec3>& places) {
    return raster_viewpoint(places, site_geometry(places));
  };
  EXPECT_FALSE(found({}));
  EXPECT_FALSE(found({Vec3(0, 0, 0)}));
  EXPECT_FALSE(found({Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(-0.1, 0, 0)}));
  std::vector<Vec3> flat;  // whose rows lie on lines
  for (int i = 0; i < 400; ++i) flat.push_back({i % 20 / 20.0 - 0.5, i / 20 / 20.0 - 0.5, 0});
  EXPECT_FALSE(found(flat));
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const auto& points :
         {test::sphere(4000, seed), test::torus(4000, seed), test::ellipsoid(4000, seed, 0)}) {
      std::vector<Vec3> places;
      for (const Point& p : points) places.push_back(Vec3(p[0], p[1], p[2]) / 4);
      EXPECT_FALSE(found(places)) << seed;
    }
}

}  // namespace
}  // namespace filmsticking
