// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/reach.h"

#include <gtest/gtest.h>

#include "labelling/folds.h"
#include "labelling/repair.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

std::int64_t sites_off(const test::LabelSetting& l) {
  std::int64_t off = 0;
  for (std::size_t v = 0; v < l.s.set.size(); ++v) off += l.labelling.census(static_cast<Index>(v)).off();
  return off;
}

int folds(const test::LabelSetting& l) {
  int count = 0;
  for (std::size_t t = 0; t < l.inside.size(); ++t) count += folded(l.labelling, static_cast<Index>(t));
  return count;
}

TEST(Reach, KeepsTheTopologyMakesNoFoldAndTakesSitesOntoTheSurface) {
  std::int64_t reached = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Setting s(seed % 2 ? test::torus(300, seed) : test::box(300, seed, {1, 1, 0.05}));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed));
    repair(l.labelling);
    const auto euler = euler_if_manifold(s, l.inside);
    const test::Topology before = test::topology(s, l.inside);
    const std::int64_t off = sites_off(l);
    const int folds_before = folds(l);
    reach(l.labelling);
    EXPECT_EQ(euler_if_manifold(s, l.inside), euler);
    const test::Topology after = test::topology(s, l.inside);
    EXPECT_EQ(after.components, before.components);
    EXPECT_EQ(after.handles, before.handles);
    EXPECT_LE(folds(l), folds_before);
    EXPECT_LT(sites_off(l), off);
    reached += l.labelling.counts.reached;
  }
  EXPECT_GT(reached, 0);
}

TEST(Reach, TakesASiteThatATetrahedronIsMissingFor) {
  const Setting s(test::ellipsoid(500, 1, 0));
  test::LabelSetting l(s, test::labels_where(s, [](const Point&) { return true; }));
  repair(l.labelling);
  ASSERT_EQ(sites_off(l), 0);
  // Take the tetrahedra of a site away whose star keeps a manifold without it.
  for (Index v = 0; v < static_cast<Index>(s.set.size()); ++v) {
    l.labelling.search_star(v);
    Move move;
    for (Index t : l.labelling.star())
      if (l.inside[t]) move.push_back(t);
    const Effect e = l.labelling.effect(move);
    if (e.surplus != 0 || e.euler != 0 || move.size() > 2) continue;
    l.labelling.apply(move);
    ASSERT_EQ(sites_off(l), 1);
    reach(l.labelling);
    EXPECT_EQ(sites_off(l), 0);
    return;
  }
  FAIL() << "no such site";
}

}  // namespace
}  // namespace filmsticking
