// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/attraction_weights.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "film/initial_surface.h"
#include "geometry/nearest.h"
#include "points/site_set.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

TEST(AttractionWeights, StayInThePapersInterval) {
  const SiteSet set = make_site_set(test::sphere(500, 8));
  Surface film = bounding_sphere(set.perturbed);
  std::vector<Index> off;
  for (Index s = 0; s < static_cast<Index>(set.size()); ++s) off.push_back(s);
  std::vector<double> weights;
  const std::size_t weighted = attraction_weights(film, set.perturbed, off, weights);
  EXPECT_GT(weighted, 0u);
  const SurfaceTree surface(film);
  for (std::size_t s = 0; s < weights.size(); ++s) {
    if (weights[s] == 0) continue;
    double to_vertex2 = 1e300;
    for (const Vec3& v : film.positions)
      to_vertex2 = std::min(to_vertex2, (v - set.perturbed[s]).squaredNorm());
    EXPECT_GT(weights[s], (surface.nearest(set.perturbed[s]).point - set.perturbed[s]).squaredNorm());
    EXPECT_LT(weights[s], to_vertex2);
  }
}

TEST(AttractionWeights, ASiteBehindAnotherWaits) {
  const Surface film = bounding_sphere({{0.5, 0.5, 0.5}});
  const Vec3 out = Vec3(1, 0.2, 0.3).normalized();
  std::vector<double> weights;
  attraction_weights(film, {0.6 * out, 0.3 * out}, {0, 1}, weights);
  EXPECT_GT(weights[0], 0);
  EXPECT_EQ(weights[1], 0);
}

}  // namespace
}  // namespace filmsticking
