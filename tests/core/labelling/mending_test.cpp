// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/mending.h"

#include <gtest/gtest.h>

#include <cmath>

#include "labelling/repair.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

// Any part, at any price: what is kept leaves fewer handles or pieces, and not more of either; else nothing
// changes.
TEST(Mending, AMendLeavesFewerHandlesOrPiecesOrChangesNothing) {
  std::int64_t tunnels = 0, undone = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const Setting s(seed % 2 ? test::sphere(120, seed) : test::torus(200, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed));
    repair(l.labelling);
    Mending mending(l.labelling);
    mending.name_pieces();
    test::Random random(seed);
    for (int i = 0; i < 40; ++i) {
      const Move part = test::random_part(s, l.inside, random, 1 + i % 12);
      const test::Topology before = test::topology(s, l.inside);
      const std::vector<char> labels = l.inside;
      const LabelCounts counts = l.labelling.counts;
      const double worth = i % 3 ? 3 : 1e100;
      mending.try_all({part}, labels[part[0]], {worth, i % 2 ? worth : 0, 0, i % 4 == 0});
      ASSERT_TRUE(euler_if_manifold(s, l.inside));
      const test::Topology after = test::topology(s, l.inside);
      EXPECT_LE(after.handles, before.handles);
      EXPECT_LE(after.components, before.components);
      const bool kept = after.handles < before.handles || after.components < before.components;
      EXPECT_EQ(l.inside != labels, kept);
      EXPECT_EQ(l.labelling.counts.tunnels - counts.tunnels, after.handles < before.handles);
      EXPECT_EQ(l.labelling.counts.tears - counts.tears, after.components < before.components);
      undone += !kept && l.labelling.grows(part);
    }
    tunnels += l.labelling.counts.tunnels;
    const std::vector<Census> right = test::censuses_by_hand(s.mesh, l.inside, s.set.size());
    for (std::size_t v = 0; v < right.size(); ++v) {
      EXPECT_EQ(l.labelling.census(static_cast<Index>(v)).inside, right[v].inside);
      EXPECT_EQ(l.labelling.census(static_cast<Index>(v)).outside, right[v].outside);
    }
  }
  EXPECT_GT(tunnels, 0);
  EXPECT_GT(undone, 0);
}

// What is between two ellipsoids joins them, if a piece less is worth it.
TEST(Mending, JoinsPiecesIfThatIsWorthIt) {
  const test::TwoEllipsoids shape{2.05};
  int joined = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Setting s(shape.samples(seed));
    test::LabelSetting l(s, test::labels_where(s, [&](const Point& p) { return shape.in(p); }));
    repair(l.labelling);
    if (test::topology(s, l.inside).components != 2) continue;
    Move part;
    for (std::size_t t = 0; t < l.inside.size(); ++t) {
      if (s.infinite(t) || l.inside[t]) continue;
      const Point p = s.set.to_input(s.centre(t));
      if (std::hypot(p[1], p[2]) < 0.1 && std::abs(p[0] - 1.025) < 0.1) part.push_back(static_cast<Index>(t));
    }
    Mending mending(l.labelling);
    mending.name_pieces();
    const std::vector<char> before = l.inside;
    mending.try_all({part}, 0, {0, 1e-9});
    EXPECT_EQ(l.inside, before) << seed;
    mending.try_all({part}, 0, {0, 1e100});
    EXPECT_EQ(l.labelling.counts.tears, test::topology(s, l.inside).components == 1) << seed;
    joined += static_cast<int>(l.labelling.counts.tears);
  }
  EXPECT_GT(joined, 0);
}

TEST(Mending, APartThatAnotherHasChangedIsNotTried) {
  const Setting s(test::torus(200, 1));
  test::LabelSetting l(s, test::random_labels(s.mesh, 1));
  repair(l.labelling);
  Mending mending(l.labelling);
  mending.name_pieces();
  const std::vector<char> labels = l.inside;
  test::Random random(1);
  for (int i = 0; i < 40; ++i) {
    const Move part = test::random_part(s, l.inside, random, 3);
    mending.try_all({part}, !labels[part[0]], {1e100, 1e100});
  }
  EXPECT_EQ(l.inside, labels);
}

TEST(Mending, CountsTheHandlesOfTheSurface) {
  std::int64_t most = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Setting s(test::torus(200, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed));
    repair(l.labelling);
    Mending mending(l.labelling);
    EXPECT_EQ(mending.name_pieces(), test::topology(s, l.inside).components + 1) << seed;
    EXPECT_EQ(mending.handles(), test::topology(s, l.inside).handles) << seed;
    most = std::max(most, mending.handles());
  }
  EXPECT_GT(most, 1);
}

}  // namespace
}  // namespace filmsticking
