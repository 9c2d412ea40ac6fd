// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/warp.h"

#include <gtest/gtest.h>

#include "labelling/repair.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(Warp, KeepsTheTopologyAndOnlyTakesLabelsOfTheAim) {
  std::int64_t warped = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Setting s(test::torus(300, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed));
    repair(l.labelling);
    const test::Topology before = test::topology(s, l.inside);
    const auto euler = euler_if_manifold(s, l.inside);
    const std::vector<char> from = l.inside, aim = test::random_labels(s.mesh, seed + 1000);
    warp(l.labelling, aim);
    EXPECT_EQ(euler_if_manifold(s, l.inside), euler) << seed;
    const test::Topology after = test::topology(s, l.inside);
    EXPECT_EQ(after.components, before.components) << seed;
    EXPECT_EQ(after.handles, before.handles) << seed;
    for (std::size_t t = 0; t < aim.size(); ++t)
      EXPECT_TRUE(l.inside[t] == from[t] || l.inside[t] == aim[t]) << t;
    EXPECT_EQ(test::differences(l.inside, from), l.labelling.counts.warped);
    warped += l.labelling.counts.warped;
  }
  EXPECT_GT(warped, 0);
}

TEST(Warp, StopsWhereNoSingleStepIsLeft) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Setting s(test::torus(300, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed));
    repair(l.labelling);
    const std::vector<char> aim = test::random_labels(s.mesh, seed + 1000);
    warp(l.labelling, aim);
    for (std::size_t i = 0; i < aim.size(); ++i) {
      const Move move{static_cast<Index>(i)};
      if (l.inside[i] == aim[i] || s.infinite(i) || !l.labelling.grows(move)) continue;
      const Effect e = l.labelling.effect(move);
      EXPECT_TRUE(e.surplus != 0 || e.euler != 0) << seed << ' ' << i;
    }
  }
}

TEST(Warp, ReachesTheAimWhereTheTopologyIsTheSame) {
  const Setting s(test::ellipsoid(2000, 3, 0));
  const auto level = [](const Point& p) { return Vec3(p[0], p[1] / 0.8, p[2] / 0.6).norm(); };
  test::LabelSetting whole(s, test::labels_where(s, [&](const Point& p) { return level(p) < 0.99; }));
  test::LabelSetting part(s, test::labels_where(s, [&](const Point& p) {
                            return level(p) < 0.99 && p[0] < 0.4;
                          }));  // an end less
  repair(whole.labelling);
  repair(part.labelling);
  warp(part.labelling, whole.inside);
  EXPECT_GT(part.labelling.counts.warped, 100);
  // Some steps need two tetrahedra at once: of two dozen such clouds, 0 to 14 % stay different.
  EXPECT_LT(test::differences(whole.inside, part.inside), part.labelling.counts.warped / 5);
}

}  // namespace
}  // namespace filmsticking
