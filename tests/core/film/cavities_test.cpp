// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/cavities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "film/film_step.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

LabelledFilm film_of(const Setting& s, std::vector<char> inside) {
  return {std::make_shared<const PowerComplex>(s.set.perturbed, s.mesh.tets), std::move(inside)};
}

std::vector<char> cavities_of(const Setting& s, const std::vector<char>& inside) {
  return cavities(s.mesh, s.set.perturbed, s.geometry.spacing, inside, site_sides(film_of(s, inside)));
}

std::vector<char> all_finite(const Setting& s) {
  std::vector<char> inside(s.mesh.size());
  for (std::size_t t = 0; t < inside.size(); ++t) inside[t] = static_cast<char>(!s.infinite(t));
  return inside;
}

// A convex solid's hull is its film: nothing is missed. With an inner wall, what the wall encloses is a
// cavity, all of it, and nearly nothing of the wall is.
TEST(Cavities, AreWhatWallsOfMissedSitesEnclose) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    auto points = test::sphere(1500, seed);
    const Setting solid(points);
    const std::vector<char> none = cavities_of(solid, all_finite(solid));
    EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0) << "seed " << seed;

    const double radius = 0.5 + 0.03 * static_cast<double>(seed);
    for (const Point& p : test::sphere(1000, seed + 100, {0, 0, 0}, radius)) points.push_back(p);
    const Setting hollow(points);
    const std::vector<char> cavity = cavities_of(hollow, all_finite(hollow));
    int wall = 0, left = 0;
    for (std::size_t t = 0; t < cavity.size(); ++t) {
      if (hollow.infinite(t)) continue;
      const double r = hollow.centre(t).norm() * hollow.set.side;
      EXPECT_TRUE(r > 0.8 * radius || cavity[t]) << "seed " << seed;
      wall += r > radius, left += r > radius && cavity[t];
    }
    EXPECT_LT(left, wall / 20) << "rooms of a few tetrahedra in the wall";
  }
}

TEST(Cavities, ArePartOfTheInsideOfAnyLabels) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const std::vector<Point> cloud = test::awkward(seed);
    if (make_site_set(cloud).size() < 5) continue;
    const Setting s(cloud);
    if (s.mesh.size() == 0) continue;
    test::Random random(seed);
    std::vector<char> inside = all_finite(s);
    for (char& label : inside) label = static_cast<char>(label && random.below(8) != 0);
    const std::vector<char> cavity = cavities_of(s, inside);
    ASSERT_EQ(cavity.size(), inside.size());
    for (std::size_t t = 0; t < cavity.size(); ++t) EXPECT_LE(cavity[t], inside[t]) << "seed " << seed;
    EXPECT_EQ(cavity, cavities_of(s, inside));
  }
}

}  // namespace
}  // namespace filmsticking
