// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/sculpt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "labelling/repair.h"
#include "support/clouds.h"
#include "support/field_setting.h"
#include "surface/surface_quality.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(Sculpt, FollowsTheEvidenceWhereTheBeliefIsVague) {
  const Setting s(test::sphere(3000, 7));
  std::vector<double> belief(s.mesh.size(), -1);
  for (std::size_t t = 0; t < s.mesh.size(); ++t)
    if (!s.mesh.tets.infinite(static_cast<Index>(t))) belief[t] = s.centre(t).norm() < 0.45 ? 1 : 0;
  std::vector<double> hold(s.mesh.size(), 0);
  for (std::size_t t = 0; t < hold.size(); ++t)
    for (const double area : s.evidence.area[t]) hold[t] += 0.1 * area * belief[t];
  std::vector<char> inside = Sculptor(s.mesh, s.evidence, hold).cut();
  test::LabelSetting l(s, std::move(inside));
  repair(l.labelling);
  const Surface surface = test::surface_of(s, l.inside);
  EXPECT_GT(surface.site.size(), 2990u);
  EXPECT_LT(surface_quality(surface, s.geometry).disagreement, 0.02);
}

TEST(Sculpt, ACutThatGoesOnIsACutFromTheStart) {
  const Setting s(test::torus(1500, 4));
  test::Random random(5);
  std::vector<double> hold(s.mesh.size());
  for (std::size_t t = 0; t < hold.size(); ++t)
    for (const double area : s.evidence.area[t]) hold[t] += random.uniform(-1, 1) * area;
  for (const bool open : {false, true}) {
    std::vector<double> now = hold;
    Sculptor sculptor(s.mesh, s.evidence, now, open);
    for (int turn = 0; turn < 5; ++turn) {
      const std::vector<char> inside = sculptor.cut();
      EXPECT_GT(std::count(inside.begin(), inside.end(), 1), 0);
      EXPECT_EQ(inside, Sculptor(s.mesh, s.evidence, now, open).cut());
      for (std::size_t t = 0; t < now.size(); ++t) {
        if (random.below(3) > 0) continue;
        const double before = now[t];
        now[t] *= random.uniform(1, 3);
        sculptor.hold_firmly(static_cast<Index>(t), before, now[t]);
      }
    }
  }
}

TEST(Sculpt, OnlyAnOpenCutReachesInfinity) {
  const Setting s(test::torus(500, 4));
  const std::vector<double> hold(s.mesh.size(), 1e6);  // all would be inside
  const std::vector<char> closed = Sculptor(s.mesh, s.evidence, hold).cut();
  const std::vector<char> open = Sculptor(s.mesh, s.evidence, hold, true).cut();
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    EXPECT_EQ(closed[t] != 0, !s.infinite(t));
    EXPECT_TRUE(open[t]);
  }
}

}  // namespace
}  // namespace filmsticking
