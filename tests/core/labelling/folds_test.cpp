// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/folds.h"

#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

int folds(const test::LabelSetting& l) {
  int count = 0;
  for (std::size_t t = 0; t < l.inside.size(); ++t) count += folded(l.labelling, static_cast<Index>(t));
  return count;
}

TEST(Folds, MoreFoldsIsTheDifferenceThatAMoveMakes) {
  int changes = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Setting s(test::box(150, seed, {1, 1, 0.1}));
    test::LabelSetting l(s, test::labels_where(s, [](const Point& p) { return p[0] + p[1] < 1.4; }));
    test::Random random(seed);
    for (int i = 0; i < 60; ++i) {
      const Move move = test::random_part(s, l.inside, random, 1);
      const auto folds_there = [&] {
        int count = folded(l.labelling, move[0]);
        for (Index u : s.mesh.tets.neighbours[move[0]]) count += folded(l.labelling, u);
        return count;
      };
      const std::vector<char> labels = l.inside;
      const int more = more_folds(l.labelling, move), before = folds_there();
      ASSERT_EQ(l.inside, labels);
      l.labelling.flip(move[0]);
      EXPECT_EQ(folds_there() - before, more);
      changes += more != 0;
    }
  }
  EXPECT_GT(changes, 0);
}

// A flat tetrahedron outside a plate, with the surface on both of its sides, is a fold; without flat
// tetrahedra there is none.
TEST(Folds, AreAtFlatTetrahedraOnly) {
  const Setting flat(test::box(150, 1, {1, 1, 0.1})), round(test::ellipsoid(150, 1, 0));
  test::LabelSetting on_flat(flat, test::random_labels(flat.mesh, 1));
  test::LabelSetting on_round(round, test::random_labels(round.mesh, 1));
  int count = 0;
  for (std::size_t t = 0; t < flat.mesh.size(); ++t)
    if (folded(on_flat.labelling, static_cast<Index>(t))) {
      ++count;
      EXPECT_NE(flat.mesh.flat[t], 0);
    }
  EXPECT_GT(count, 0);
  EXPECT_EQ(folds(on_round), 0);
}

// A flat cloud has no other surface.
TEST(Folds, AFlatCloudHasNone) {
  const Setting s(test::box(60, 1, {1, 1, 0}));
  test::LabelSetting l(s, test::labels_where(s, [](const Point&) { return true; }));
  EXPECT_EQ(folds(l), 0);
}

}  // namespace
}  // namespace filmsticking
