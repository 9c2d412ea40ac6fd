// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/ball.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(BallWidths, ReachTheOutsideAndNoSolid) {
  const Setting s(test::torus(4000, 4));
  const auto width = ball_widths(s.mesh, s.set.perturbed, s.geometry.spacing, 0, 1e9);
  int wrong = 0, deep = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
    const Point x = s.set.to_input(s.mesh.circumcentre[t]);
    const double off = std::hypot(std::hypot(x[0], x[1]) - 1, x[2]) - 0.4;
    if (std::abs(off) < 0.15) continue;  // near the surface both are right
    ++deep;
    wrong += (off < 0) != (width[t] < 2.5);
  }
  EXPECT_GT(deep, 100);
  EXPECT_LT(wrong, deep / 100);
}

TEST(BallWidths, AreThoseOfTheWholeRangeClamped) {
  const Setting s(test::torus(2000, 5));
  const auto all = ball_widths(s.mesh, s.set.perturbed, s.geometry.spacing, 0, 1e9);
  const auto some = ball_widths(s.mesh, s.set.perturbed, s.geometry.spacing, 1.5, 3);
  for (std::size_t t = 0; t < all.size(); ++t) EXPECT_EQ(some[t], std::clamp(all[t], 1.5, 3.0));
}

TEST(BallWidths, NoneIsWiderThanItsWidestNeighbour) {
  const Setting s(test::sphere(2000, 6));
  const auto width = ball_widths(s.mesh, s.set.perturbed, s.geometry.spacing, 0, 1e9);
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
    double widest = 0;
    for (const Index u : s.mesh.tets.neighbours[t]) widest = std::max(widest, width[u]);
    EXPECT_LE(width[t], widest);
  }
}

TEST(BallWidths, AreInUnitsOfTheSpacing) {
  const Setting s(test::sphere(1000, 8));
  std::vector<double> twice = s.geometry.spacing;
  for (double& spacing : twice) spacing *= 2;
  const auto width = ball_widths(s.mesh, s.set.perturbed, s.geometry.spacing, 0, 1e9);
  const auto half = ball_widths(s.mesh, s.set.perturbed, twice, 0, 1e9);
  for (std::size_t t = 0; t < s.mesh.size(); ++t)
    if (width[t] < 1e8) {
      EXPECT_NEAR(half[t], width[t] / 2, 1e-6 * width[t]);
    }
}

}  // namespace
}  // namespace filmsticking
