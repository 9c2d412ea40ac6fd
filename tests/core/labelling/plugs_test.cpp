// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/plugs.h"

#include <gtest/gtest.h>

#include "labelling/narrow.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(Plugs, AreTheConnectedPartsOfWhatIsNarrowOutside) {
  std::size_t count = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Setting s(test::torus(300, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed, 3));
    const double radius = 1.5;
    const std::vector<Move> found = plugs(l.labelling, radius, 0);
    std::vector<int> plug(s.mesh.size(), -1);
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_TRUE(i == 0 || found[i - 1].size() <= found[i].size());
      for (Index t : found[i]) {
        EXPECT_EQ(plug[t], -1);
        plug[t] = static_cast<int>(i);
      }
    }
    for (std::size_t t = 0; t < s.mesh.size(); ++t) {
      if (plug[t] < 0) continue;
      EXPECT_FALSE(l.inside[t]);
      EXPECT_TRUE(narrow(l.labelling, static_cast<Index>(t), radius));
      for (Index u : s.mesh.tets.neighbours[t])  // nothing narrow beside a plug is left out of it
        EXPECT_TRUE(plug[u] == plug[t] || l.inside[u] || !narrow(l.labelling, u, radius));
    }
    count += found.size();
    EXPECT_TRUE(plugs(l.labelling, radius, radius).empty());  // all have been met
  }
  EXPECT_GT(count, 10u);
}

}  // namespace
}  // namespace filmsticking
