// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/ways.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "labelling/narrow.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(Ways, ASingleTetrahedronIsAShardAndASolidIsNone) {
  const Setting s(test::TwoEllipsoids{3}.samples(1));
  const test::TwoEllipsoids shape{3};
  std::vector<char> inside = test::labels_where(s, [&](const Point& p) { return p[0] > 1.5 && shape.in(p); });
  Index lone = kNone, solid = kNone;
  for (std::size_t t = 0; t < inside.size(); ++t) {
    if (s.infinite(t)) continue;
    const Point p = s.set.to_input(s.centre(t));
    if (p[0] < 0.5 && std::abs(p[0]) > 0.8 && shape.in(p)) lone = static_cast<Index>(t);
    if (inside[t]) solid = static_cast<Index>(t);
  }
  ASSERT_NE(lone, kNone);
  inside[lone] = 1;
  test::LabelSetting l(s, inside);
  PieceNames pieces;
  pieces.name(l.labelling);
  const std::vector<char> shard = shards(l.labelling, pieces, s.set.perturbed, 0);
  EXPECT_TRUE(shard[pieces.of(lone)]);
  EXPECT_FALSE(shard[pieces.of(solid)]);
  // Of the outside, which holds the infinite tetrahedra, none is.
  const std::vector<char> outside = shards(l.labelling, pieces, s.set.perturbed, 1);
  EXPECT_EQ(std::count(outside.begin(), outside.end(), 1), 0);
}

TEST(Ways, JoinAShardToAnotherPieceThroughWhatIsNarrow) {
  std::size_t count = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Setting s(test::torus(250, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed, 1));
    PieceNames pieces;
    pieces.name(l.labelling);
    for (const char label : {char{0}, char{1}}) {
      const double radius = 2;
      const std::vector<char> shard = shards(l.labelling, pieces, s.set.perturbed, label);
      std::size_t before = 0;
      for (const Move& way : ways(l.labelling, pieces, s.set.perturbed, radius, label)) {
        EXPECT_GE(way.size(), before);
        before = way.size();
        std::set<Index> joined;
        for (Index t : way) {
          EXPECT_EQ(l.inside[t], label);
          EXPECT_TRUE(narrow(l.labelling, t, radius));
          for (Index u : s.mesh.tets.neighbours[t])
            if (l.inside[u] != label) joined.insert(pieces.of(u));
        }
        EXPECT_GE(joined.size(), 2u);
        EXPECT_TRUE(std::any_of(joined.begin(), joined.end(), [&](Index name) { return shard[name] != 0; }));
        ++count;
      }
    }
  }
  EXPECT_GT(count, 100u);
}

}  // namespace
}  // namespace filmsticking
