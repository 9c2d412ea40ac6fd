// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/repair.h"

#include <gtest/gtest.h>

#include "labelling/mend.h"
#include "labelling/reach.h"
#include "labelling/warp.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(Repair, MakesAManifoldOfAnyLabels) {
  std::int64_t singular = 0, erosions = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Setting s(seed % 2 ? test::sphere(120, seed) : test::torus(200, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed, 1 + static_cast<int>(seed % 5)));
    repair(l.labelling);
    EXPECT_TRUE(euler_if_manifold(s, l.inside)) << seed;
    for (std::size_t t = 0; t < l.inside.size(); ++t) EXPECT_FALSE(l.inside[t] && s.infinite(t));
    singular += l.labelling.counts.singular, erosions += l.labelling.counts.erosions;
  }
  EXPECT_GT(singular, 0);  // there was something to do
  EXPECT_GT(erosions, 0);
}

TEST(Repair, LeavesAManifoldAsItIs) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Setting s(test::torus(200, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed));
    repair(l.labelling);
    const std::vector<char> once = l.inside;
    repair(l.labelling);
    EXPECT_EQ(l.labelling.counts.singular, 0) << seed;
    EXPECT_EQ(l.inside, once) << seed;
  }
}

TEST(Repair, MakesAManifoldAtAllSitesThatAreNotExempt) {
  bool singular = false;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Setting s(test::torus(200, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed));
    test::Random random(seed);
    std::vector<char> exempt(s.set.size());
    for (char& site : exempt) site = random.below(3) == 0;
    repair(l.labelling, exempt);
    const std::vector<Census> censuses = test::censuses_by_hand(s.mesh, l.inside, s.set.size());
    for (std::size_t v = 0; v < censuses.size(); ++v) {
      EXPECT_TRUE(exempt[v] || censuses[v].plain()) << seed << ' ' << v;
      singular = singular || !censuses[v].plain();
    }
  }
  EXPECT_TRUE(singular);  // exempt sites were left
}

TEST(Repair, TheBestMoveAtASiteLowersTheSurplus) {
  const Setting s(test::torus(200, 3));
  test::LabelSetting l(s, test::random_labels(s.mesh, 3));
  int moves = 0;
  for (const Index v : l.labelling.take_census()) {
    const Move move = best_repair(l.labelling, v);
    if (move.empty()) continue;
    ++moves;
    EXPECT_LT(l.labelling.effect(move).surplus, 0) << v;
  }
  EXPECT_GT(moves, 0);
}

// On a moment curve all sites are neighbours: the repair took the fourth power of the sites, minutes for
// 2,000.
TEST(Repair, Regression_WhereAllSitesAreNeighboursTheWorkIsBounded) {
  std::vector<Point> points;
  for (int i = 0; i < 300; ++i) {
    const double x = i / 150.0 - 1;
    points.push_back({x, x * x, x * x * x});
  }
  const Setting s(points);
  test::LabelSetting l(s, test::random_labels(s.mesh, 1));
  repair(l.labelling);
  EXPECT_TRUE(euler_if_manifold(s, l.inside));
  warp(l.labelling, test::random_labels(s.mesh, 2));
  reach(l.labelling);
  plug_gaps(l.labelling);
  mend(l.labelling, s.set.perturbed);
  EXPECT_TRUE(euler_if_manifold(s, l.inside));
  EXPECT_LE(l.labelling.counts.visits, 11000 * static_cast<std::int64_t>(points.size()));
  EXPECT_GT(l.labelling.counts.stripped, 0);  // the bound was met
}

}  // namespace
}  // namespace filmsticking
