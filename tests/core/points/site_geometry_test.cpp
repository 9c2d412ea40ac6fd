// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/site_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "points/site_set.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

std::vector<Vec3> places_of(const std::vector<Point>& points) {
  std::vector<Vec3> places;
  for (const Point& p : points) places.emplace_back(p[0], p[1], p[2]);
  return places;
}

TEST(SiteGeometry, NeighboursAreTheNearestInOrder) {
  const auto sites = places_of(test::torus(500, 1));
  const SiteGeometry geometry = site_geometry(sites);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    std::vector<double> distance;
    for (std::size_t j = 0; j < sites.size(); ++j)
      if (j != i) distance.push_back((sites[j] - sites[i]).norm());
    std::sort(distance.begin(), distance.end());
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_EQ((sites[geometry.near[i][k]] - sites[i]).norm(), distance[k]);
    EXPECT_NEAR(neighbour_radius(geometry, static_cast<Index>(i)), distance[kNeighbours - 1], 1e-12);
  }
}

// The spacing is the side of the square that one sample covers.
TEST(SiteGeometry, SpacingIsTheRootOfTheAreaOfASample) {
  const int n = 4000;
  const SiteGeometry geometry = site_geometry(places_of(test::sphere(n, 2)));
  double mean = 0;
  for (const double spacing : geometry.spacing) mean += spacing / n;
  EXPECT_NEAR(mean / std::sqrt(4 * M_PI / n), 1, 0.1);
}

TEST(SiteGeometry, NormalsAreThoseOfTheSurfaceUpToSign) {
  const auto sites = places_of(test::sphere(4000, 3));
  const SiteGeometry geometry = site_geometry(sites);
  int right = 0;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    EXPECT_NEAR(geometry.normal[i].norm(), 1, 1e-9);
    right += std::abs(geometry.normal[i].dot(sites[i])) > 0.98;
  }
  EXPECT_GT(right, 3960);
}

TEST(SiteGeometry, OnAPlaneNothingVaries) {
  test::Random random(4);
  std::vector<Vec3> sites;
  for (int i = 0; i < 300; ++i) {
    const double x = random.uniform(), y = random.uniform();
    sites.emplace_back(x, y, 0.5 * x - 0.25 * y);
  }
  const SiteGeometry geometry = site_geometry(sites);
  const Vec3 normal = Vec3(-0.5, 0.25, 1).normalized();
  for (std::size_t i = 0; i < sites.size(); ++i) {
    EXPECT_NEAR(geometry.variation[i], 0, 1e-9);
    EXPECT_NEAR(std::abs(geometry.normal[i].dot(normal)), 1, 1e-9);
  }
}

TEST(SiteGeometry, ALoneSiteIsOffItsNeighboursButSpacedAsThey) {
  auto points = test::sphere(2000, 5);
  points.push_back({0, 0, 1.5});
  const SiteGeometry geometry = site_geometry(places_of(points));
  const Index lone = static_cast<Index>(points.size()) - 1;
  EXPECT_GT(geometry.offset[lone], 2);
  EXPECT_LT(near_spacing(geometry, lone), geometry.spacing[lone] / 2);
}

TEST(SiteGeometry, OfFewSitesIsFinite) {
  for (int n = 0; n <= 5; ++n) {
    const auto sites = places_of(test::sphere(n, 6));
    const SiteGeometry geometry = site_geometry(sites);
    ASSERT_EQ(geometry.spacing.size(), sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) {
      EXPECT_TRUE(std::isfinite(geometry.spacing[i]));
      EXPECT_TRUE(geometry.normal[i].allFinite());
      EXPECT_TRUE(std::isfinite(geometry.variation[i]));
      EXPECT_EQ(std::count(geometry.near[i].begin(), geometry.near[i].end(), kNone), std::max(0, 7 - n));
    }
  }
}

}  // namespace
}  // namespace filmsticking
