// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/surface_sheets.h"

#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

TEST(SurfaceSheets, AreWhatTheStarsSay) {
  const test::FieldSetting s(test::torus(250, 3));
  for (int turn = 0; turn < 8; ++turn) {
    std::vector<char> inside = test::random_labels(s.mesh, static_cast<std::uint64_t>(turn));
    if (turn % 2 == 1)  // smooth as well
      for (std::size_t t = 0; t < inside.size(); ++t)
        inside[t] = !s.infinite(t) && s.mesh.circumradius[t] < 0.1 * turn;
    const std::vector<Sheets> sheets = surface_sheets(s.mesh, inside, s.set.size());
    const std::vector<Census> censuses = test::censuses_by_hand(s.mesh, inside, s.set.size());
    for (std::size_t v = 0; v < sheets.size(); ++v) {
      const int pieces = censuses[v].inside + censuses[v].outside;
      EXPECT_EQ(sheets[v], pieces == 1 ? Sheets::None : pieces == 2 ? Sheets::Disc : Sheets::Other) << v;
    }
  }
}

}  // namespace
}  // namespace filmsticking
