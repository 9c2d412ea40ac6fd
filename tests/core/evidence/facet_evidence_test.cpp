// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/facet_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(FacetEvidence, IsTheSameFromBothSides) {
  const Setting s(test::torus(1000, 1));
  for (std::size_t t = 0; t < s.mesh.size(); ++t)
    for (int k = 0; k < 4; ++k) {
      const Index m = s.mesh.mirror[t][k];
      EXPECT_EQ(s.evidence.area[t][k], s.evidence.area[m / 4][m % 4]);
      EXPECT_EQ(s.evidence.votes[t][k], s.evidence.votes[m / 4][m % 4]);
      EXPECT_EQ(s.evidence.cost[t][k], s.evidence.cost[m / 4][m % 4]);
    }
}

TEST(FacetEvidence, FacetsAtInfinityHaveNone) {
  const Setting s(test::sphere(500, 2));
  int infinite = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t)
    for (int k = 0; k < 4; ++k) {
      const auto& c = s.mesh.tets.corners[t];
      if (c[kFacet[k][0]] != kNone && c[kFacet[k][1]] != kNone && c[kFacet[k][2]] != kNone) continue;
      ++infinite;
      EXPECT_EQ(s.evidence.area[t][k], 0);
      EXPECT_EQ(s.evidence.votes[t][k], 0);
      EXPECT_EQ(s.evidence.cost[t][k], 0);
    }
  EXPECT_GT(infinite, 0);
}

// The surface of a convex shape is its hull: hull facets have most votes, and long facets inside hardly any.
TEST(FacetEvidence, VotesAreForTheFacetsOfTheSurface) {
  const Setting s(test::ellipsoid(3000, 3, 0));
  double hull = 0, hull_votes = 0, deep = 0, deep_votes = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t)
    for (int k = 0; k < 4; ++k) {
      if (s.evidence.area[t][k] == 0) continue;
      const auto& c = s.mesh.tets.corners[t];
      if (s.mesh.tets.infinite(s.mesh.tets.neighbours[t][k])) {
        ++hull, hull_votes += s.evidence.votes[t][k];
        continue;
      }
      double longest = 0;
      for (int i = 0; i < 3; ++i)
        longest = std::max(
            longest, (s.set.perturbed[c[kFacet[k][i]]] - s.set.perturbed[c[kFacet[k][(i + 1) % 3]]]).norm());
      if (longest > 0.3) ++deep, deep_votes += s.evidence.votes[t][k];
    }
  ASSERT_GT(hull, 1000);
  ASSERT_GT(deep, 1000);
  EXPECT_GT(hull_votes, 2 * hull);
  EXPECT_LT(deep_votes, 0.1 * deep);
}

TEST(FacetEvidence, AFacetWithMoreVotesCostsLessForItsArea) {
  const Setting s(test::torus(2000, 4));
  double least[4] = {9, 9, 9, 9}, most[4] = {0, 0, 0, 0};
  for (std::size_t t = 0; t < s.mesh.size(); ++t)
    for (int k = 0; k < 4; ++k) {
      if (!(s.evidence.area[t][k] > 1e-9)) continue;
      const double price = double{s.evidence.cost[t][k]} / double{s.evidence.area[t][k]};
      const int votes = s.evidence.votes[t][k];
      least[votes] = std::min(least[votes], price), most[votes] = std::max(most[votes], price);
    }
  // The angle to the circumspheres adds 0 to 0.6 whatever the votes.
  for (int votes = 0; votes < 4; ++votes) EXPECT_LE(most[votes] - least[votes], 0.6 + 1e-4) << votes;
  for (int votes = 1; votes < 4; ++votes) {
    EXPECT_LT(least[votes], least[votes - 1]) << votes;
    EXPECT_LT(most[votes], most[votes - 1]) << votes;
  }
}

}  // namespace
}  // namespace filmsticking
