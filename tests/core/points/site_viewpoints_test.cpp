// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/site_viewpoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "support/clouds.h"

namespace filmsticking {
namespace {

struct Cloud {
  std::vector<Point> points = test::sphere(200, 1, {100, -20, 5}, 3);
  SiteSet sites = make_site_set(points);
};

TEST(SiteViewpoints, OfNothingKnownAreNone) {
  const Cloud cloud;
  EXPECT_TRUE(site_viewpoints(cloud.sites, {}).empty());
}

TEST(SiteViewpoints, OneOfACloudIsThatOfAllSites) {
  const Cloud cloud;
  Options options;
  options.viewpoint = {1, 2, 3};
  const auto places = site_viewpoints(cloud.sites, options);
  ASSERT_EQ(places.size(), cloud.sites.size());
  for (const Vec3& place : places) {
    const Point back = cloud.sites.to_input(place);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(back[k], k + 1, 1e-9);
  }
}

TEST(SiteViewpoints, OneOfAPointGoesWithItsPointAndWins) {
  Cloud cloud;
  Options options;
  options.viewpoint = {1, 2, 3};
  std::vector<Point> own = cloud.points;
  for (Point& p : own) p[2] += 7;
  own[5][0] = std::numeric_limits<double>::quiet_NaN();
  options.viewpoints = std::make_shared<const std::vector<Point>>(own);
  const auto places = site_viewpoints(cloud.sites, options);
  ASSERT_EQ(places.size(), cloud.sites.size());
  for (std::size_t s = 0; s < places.size(); ++s) {
    const auto i = static_cast<std::size_t>(cloud.sites.input[s]);
    EXPECT_EQ(places[s].allFinite(), i != 5);
    if (i == 5) continue;
    const Point back = cloud.sites.to_input(places[s]);
    EXPECT_NEAR(back[2], cloud.points[i][2] + 7, 1e-9);
  }
}

TEST(SiteViewpoints, ADirectionIsAFarSensorAgainstIt) {
  const Cloud cloud;
  Options options;
  options.view_direction = {0, 0, -5};
  const auto places = site_viewpoints(cloud.sites, options);
  for (std::size_t s = 0; s < places.size(); ++s) {
    const Point sensor = cloud.sites.to_input(places[s]),
                site = cloud.points[static_cast<std::size_t>(cloud.sites.input[s])];
    EXPECT_NEAR(sensor[0], site[0], 1e-4);
    EXPECT_NEAR(sensor[1], site[1], 1e-4);
    EXPECT_NEAR(sensor[2] - site[2], 100 * cloud.sites.side, 1e-3);
  }
}

}  // namespace
}  // namespace filmsticking
