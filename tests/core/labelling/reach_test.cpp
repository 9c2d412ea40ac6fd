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
  std::int64_t reached = 0, fewer_off = 0;
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
    fewer_off += off - sites_off(l);
    reached += l.labelling.counts.reached;
  }
  EXPECT_GT(reached, 0);
  EXPECT_GT(fewer_off, 0);
}

// The labels leave the outermost tetrahedra outside, and with them about half of the sites.
TEST(Reach, TakesSitesOfASmoothSurface) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Setting s(test::ellipsoid(1000, seed, 0));
    test::LabelSetting l(s, test::labels_where(s, [](const Point& p) {
                           return Vec3(p[0], p[1] / 0.8, p[2] / 0.6).norm() < 0.8;
                         }));
    repair(l.labelling);
    const std::int64_t off = sites_off(l);
    ASSERT_GT(off, 50) << seed;
    reach(l.labelling);
    EXPECT_LT(sites_off(l), off - off / 10) << seed;
  }
}

}  // namespace
}  // namespace filmsticking
