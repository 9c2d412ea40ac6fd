// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/caps.h"

#include <gtest/gtest.h>

#include "labelling/narrow.h"
#include "labelling/repair.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(Caps, AreWideTetrahedraOutsideBesideNarrowFacets) {
  std::size_t count = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const test::BentWall wall{0.06, 0.03, 0.06};
    const Setting s(wall.samples(3000, seed));
    test::LabelSetting l(s, test::labels_where(s, [&](const Point& p) { return wall.in(p); }));
    repair(l.labelling);
    for (const double radius : {0.5, 0.75, 1.}) {
      std::size_t before = 0;
      for (const Move& side : caps(l.labelling, s.set.perturbed, radius)) {
        EXPECT_GE(side.size(), before);
        before = side.size();
        for (Index t : side) {
          EXPECT_FALSE(l.inside[t]);
          EXPECT_FALSE(s.infinite(t));
          EXPECT_EQ(s.mesh.flat[t], 0);
          EXPECT_FALSE(narrow(l.labelling, t, radius));
          int lids = 0;
          for (int k = 0; k < 4; ++k) lids += narrow_facet(l.labelling, s.set.perturbed, t, k, radius);
          EXPECT_GT(lids, 0);
        }
        ++count;
      }
    }
  }
  EXPECT_GT(count, 0u);
}

// Where the surface is smooth and closed there is nothing to cap.
TEST(Caps, OfASphereThereAreNone) {
  const Setting s(test::ellipsoid(1000, 1, 0));
  test::LabelSetting l(s, test::labels_where(s, [](const Point&) { return true; }));
  repair(l.labelling);
  EXPECT_TRUE(caps(l.labelling, s.set.perturbed, 1).empty());
}

}  // namespace
}  // namespace filmsticking
