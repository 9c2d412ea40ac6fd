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
    EXPECT_NEAR(geometry.radius[i], distance[kNeighbours - 1], 1e-12);
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

// Of slices of a scan, the nearest neighbours are on one line, whose plane is that of the slice.
TEST(SiteGeometry, Regression_SlicesFarApartHaveTheNormalsOfTheSurface) {
  for (const int apart : {1, 4, 8, 16}) {
    SCOPED_TRACE(apart);
    const int around = 100;
    const double step = 2 * M_PI / around;
    std::vector<Vec3> sites;
    for (int slice = 0; slice < 12; ++slice)
      for (int i = 0; i < around; ++i) {
        const double angle = step * (i + 0.37 * slice);
        sites.emplace_back(std::cos(angle), std::sin(angle), step * apart * slice);
      }
    const SiteGeometry geometry = site_geometry(sites);
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const Vec3 outward(sites[i].x(), sites[i].y(), 0);
      EXPECT_GT(std::abs(geometry.normal[i].dot(outward)), 0.9) << i;
      // A sample covers its share of a slice, and the way to the next; half of that at the ends.
      const double area = geometry.spacing[i] * geometry.spacing[i] / (step * step * apart);
      EXPECT_GT(area, 0.5) << i;
      EXPECT_LT(area, 3) << i;
    }
  }
}

TEST(SiteGeometry, PointsOnOneCurveAreDescribedByTheNearest) {
  std::vector<Vec3> sites;
  for (int i = 0; i < 1000; ++i) sites.emplace_back(0.001 * i, 1e-6 * i * i, 0);
  const SiteGeometry geometry = site_geometry(sites);
  EXPECT_LT(geometry.radius[500], 10 * (sites[501] - sites[500]).norm());
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
