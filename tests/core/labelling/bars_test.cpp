// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/bars.h"

#include <gtest/gtest.h>

#include <set>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(Bars, LieInsideBetweenPiecesOfTheOutside) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    // A ball with a cavity whose neck is barred, and infinite tetrahedra inside, which bar nothing.
    const Setting s(test::ball_with_cavity(seed, 0.6, 0.16));
    std::vector<char> inside = test::labels_where(s, [&](const Point& p) {
      const bool hole = std::hypot(p[0], p[1]) < 0.16 && p[2] > 0 && std::abs(p[2] - 0.8) > 0.05;
      return std::hypot(p[0], p[1], p[2]) > 0.6 && !hole;
    });
    for (std::size_t t = 0; t < inside.size(); ++t)
      if (s.infinite(t) && s.centre(t)[2] < 0) inside[t] = 1;
    test::LabelSetting l(s, inside);
    PieceNames pieces;
    pieces.name(l.labelling);
    std::size_t before = 0;
    for (const Move& bar : bars(l.labelling, pieces, s.set.perturbed, 1.5)) {
      EXPECT_GE(bar.size(), before);
      before = bar.size();
      std::set<Index> beside;
      for (Index t : bar) {
        EXPECT_TRUE(l.inside[t] && !s.infinite(t));
        for (Index u : s.mesh.tets.neighbours[t])
          if (!l.inside[u]) beside.insert(pieces.of(u));
      }
      EXPECT_GE(beside.size(), 2u);
      ++found;
    }
  }
  EXPECT_GT(found, 0);
}

}  // namespace
}  // namespace filmsticking
