// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/site_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "support/clouds.h"

namespace filmsticking {
namespace {

TEST(SiteSet, DropsNonFiniteAndRepeatedPoints) {
  const SiteSet set = make_site_set(std::vector<Point>{
      {0, 0, 0}, {NAN, 0, 0}, {1, 2, 3}, {0, 0, INFINITY}, {1, 2, 3}, {-0.0, 0, 0}, {4, 0, 0}});
  EXPECT_EQ(set.non_finite, 2);
  EXPECT_EQ(set.duplicates, 2);
  std::set<std::int32_t> ids(set.input.begin(), set.input.end());
  EXPECT_EQ(ids, (std::set<std::int32_t>{0, 2, 6}));  // of equal points the first
}

TEST(SiteSet, FitsTheUnitBoxAndGoesBack) {
  const auto points = test::box(500, 1, {3e6, 2e6, 1e6});
  const SiteSet set = make_site_set(points);
  for (std::size_t s = 0; s < set.size(); ++s) {
    const Vec3 exact = set.exact(points, s);
    EXPECT_LE(exact.cwiseAbs().maxCoeff(), 0.5 + 1e-12);
    EXPECT_LE((set.perturbed[s] - exact).cwiseAbs().maxCoeff(), kPerturbation);
    const Point back = set.to_input(exact);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(back[k], points[set.input[s]][k], 1e-8 * 3e6);
  }
}

TEST(SiteSet, DoesNotDependOnTheOrder) {
  auto points = test::sphere(300, 2);
  const SiteSet a = make_site_set(points);
  std::reverse(points.begin(), points.end());
  const SiteSet b = make_site_set(points);
  EXPECT_EQ(a.perturbed, b.perturbed);
}

TEST(SiteSet, DoesNotDependOnATurnByRightAngles) {
  auto points = test::box(300, 3, {3, 2, 1});
  points.push_back({0.1, 0.2, 0.3});
  const SiteSet a = make_site_set(points);
  for (const int turns : {1, 2, 3})
    for (int axis = 0; axis < 3; ++axis) {
      auto turned = points;
      for (Point& p : turned)
        for (int i = 0; i < turns; ++i) {
          std::swap(p[axis], p[(axis + 1) % 3]);
          p[axis] = -p[axis];
        }
      const SiteSet b = make_site_set(turned);
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t s = 0; s < a.size(); ++s) EXPECT_EQ(a.exact(points, s), b.exact(turned, s));
      EXPECT_EQ(a.perturbed, b.perturbed);
      EXPECT_EQ(a.input, b.input);
      const Point back = b.to_input(b.exact(turned, 7));
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(back[k], turned[b.input[7]][k], 1e-12);
    }
}

TEST(SiteSet, SurvivesExtremeCoordinates) {
  const double huge = std::numeric_limits<double>::max();
  const SiteSet wide = make_site_set(std::vector<Point>{{-huge, 0, 0}, {huge, 1, 2}, {0, huge, 0}});
  for (const Vec3& p : wide.perturbed) EXPECT_TRUE(p.allFinite());
  EXPECT_EQ(make_site_set(std::vector<Point>{}).size(), 0u);
  EXPECT_EQ(make_site_set(std::vector<Point>{{5e-324, 0, 0}, {0, 0, 0}}).size(), 2u);
}

TEST(SiteSet, ReadsPointsWhereTheyLie) {
  struct Scanned {
    std::uint16_t ring;
    float xyz[3];
    std::uint8_t intensity;
  };
  std::vector<Scanned> scan;
  std::vector<std::int32_t> ids;
  std::vector<Point> picked;
  for (const Point& p : test::sphere(500, 7)) {
    scan.push_back({9, {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])}, 9});
    if (scan.size() % 3 != 0) continue;
    ids.insert(ids.begin(), static_cast<std::int32_t>(scan.size()) - 1);
    const float* q = scan.back().xyz;
    picked.insert(picked.begin(), {q[0], q[1], q[2]});
  }
  const PointsView view = PointsView(scan[0].xyz, sizeof(Scanned), scan.size()).at(ids);
  ASSERT_EQ(view.size(), picked.size());
  for (std::size_t i = 0; i < picked.size(); ++i) EXPECT_EQ(view[i], picked[i]);
  const std::vector<std::int32_t> last{100, 7};
  EXPECT_EQ(view.at(last)[0], picked[100]);
  EXPECT_EQ(view.at(last)[1], picked[7]);
  const SiteSet a = make_site_set(view), b = make_site_set(picked);
  EXPECT_EQ(a.perturbed, b.perturbed);
  EXPECT_EQ(a.input, b.input);
}

}  // namespace
}  // namespace filmsticking
