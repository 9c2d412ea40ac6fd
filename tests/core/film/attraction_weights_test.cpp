// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/attraction_weights.h"

#include <gtest/gtest.h>

#include "film/initial_surface.h"
#include "geometry/nearest.h"
#include "points/site_set.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

TEST(AttractionWeights, ReachTheFilmAndNoSiteElseHasAny) {
  const SiteSet set = make_site_set(test::sphere(500, 8));
  const Surface film = bounding_sphere(set.perturbed);
  const std::vector<Index> off{3, 70, 499};
  const std::vector<double> weights = attraction_weights(film, set.perturbed, off);
  const SurfaceTree surface(film);
  for (std::size_t s = 0; s < weights.size(); ++s) {
    const double distance2 = (surface.nearest(set.perturbed[s]).point - set.perturbed[s]).squaredNorm();
    if (s == 3 || s == 70 || s == 499) {
      EXPECT_GT(weights[s], distance2);  // its power is negative at its foot: no site of the film is nearer
      EXPECT_LT(weights[s], 1.001 * distance2);
    } else {
      EXPECT_EQ(weights[s], 0);
    }
  }
}

TEST(AttractionWeights, WithoutAFilmThereAreNone) {
  EXPECT_EQ(attraction_weights({}, {{0, 0, 0}}, {0}), std::vector<double>{0});
}

}  // namespace
}  // namespace filmsticking
