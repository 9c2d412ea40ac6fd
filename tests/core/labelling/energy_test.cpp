// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/energy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "labelling/repair.h"
#include "support/clean_clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

Setting small_setting(std::uint64_t seed) {
  return Setting(seed % 2 ? test::torus(80, seed) : test::box(70, seed, {1, 1, 0.05}));
}

void expect_difference(const Effect& move, const Effect& before, const Effect& after) {
  EXPECT_EQ(move.surplus, after.surplus - before.surplus);
  EXPECT_EQ(move.euler, after.euler - before.euler);
  EXPECT_EQ(move.off, after.off - before.off);
  EXPECT_NEAR(move.cost, after.cost - before.cost, 1e-9 * (1 + std::abs(after.cost)));
}

TEST(LabelEnergy, OfAMoveIsTheDifferenceThatItMakes) {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    const Setting s = small_setting(seed);
    test::LabelSetting l(s, test::random_labels(s.mesh, seed, 1 + static_cast<int>(seed % 8)));
    test::Random random(seed);
    for (double& h : l.costs.hold) h = random.uniform(-0.01, 0.01);
    l.labelling.take_census();
    if (seed % 4 < 2) repair(l.labelling);
    for (int i = 0; i < 60; ++i) {
      const Move move = test::random_part(s, l.inside, random, 1 + i % 5);
      const Effect before = energy_of(l.labelling), change = energy_of(l.labelling, move);
      const Labelling::Made made = l.labelling.make(move);
      const Effect after = energy_of(l.labelling);
      expect_difference(change, before, after);
      expect_difference(made.effect, before, after);
      if (i % 3 > 0) continue;
      l.labelling.unmake(move, made.before);
      expect_difference({}, before, energy_of(l.labelling));
    }
  }
}

TEST(LabelEnergy, OfNothingInsideIsWhatAllSitesOffAndAllBeliefsCost) {
  const Setting s = small_setting(1);
  test::LabelSetting l(s, std::vector<char>(s.mesh.size(), 0));
  double cost = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) l.costs.hold[t] = t % 2 ? 0.25 : -0.25;
  for (std::size_t t = 1; t < s.mesh.size(); t += 2) cost += 0.25;
  for (const double off : l.costs.off) cost += off;
  l.labelling.take_census();
  const Effect all = energy_of(l.labelling);
  EXPECT_EQ(all.off, static_cast<int>(s.set.size()));
  EXPECT_EQ(all.euler, 0);
  EXPECT_EQ(all.surplus, 0);
  EXPECT_NEAR(all.cost, cost, 1e-9 * (1 + cost));
}

}  // namespace
}  // namespace filmsticking
