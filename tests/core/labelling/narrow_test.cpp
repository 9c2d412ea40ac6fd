// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/narrow.h"

#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(Narrow, ComparesTheCircumsphereWithTheLargestSpacing) {
  const Setting s(test::ellipsoid(200, 1, 0));
  test::LabelSetting l(s, test::random_labels(s.mesh, 1));
  for (std::size_t i = 0; i < s.mesh.size(); ++i) {
    const Index t = static_cast<Index>(i);
    if (s.infinite(i)) {
      EXPECT_FALSE(narrow(l.labelling, t, 1e9));
      continue;
    }
    double spacing = 0;
    for (Index v : s.mesh.tets.corners[i]) spacing = std::max(spacing, s.geometry.spacing[v]);
    const double radius = (s.mesh.circumcentre[i] - s.set.perturbed[s.mesh.tets.corners[i][0]]).norm();
    EXPECT_TRUE(narrow(l.labelling, t, 1.001 * radius / spacing));
    EXPECT_FALSE(narrow(l.labelling, t, 0.999 * radius / spacing));
    // No facet's circle is wider than the sphere; all of them together have the largest spacing.
    int narrow_facets = 0;
    for (int k = 0; k < 4; ++k)
      narrow_facets += narrow_facet(l.labelling, s.set.perturbed, t, k, 1.001 * radius / spacing);
    EXPECT_GE(narrow_facets, 3);
  }
}

TEST(Narrow, AFacetIsNarrowFromItsCircumradiusOn) {
  const Setting s(test::ellipsoid(200, 1, 0));
  test::LabelSetting l(s, test::random_labels(s.mesh, 1));
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.infinite(t)) continue;
    const auto& c = s.mesh.tets.corners[t];
    const Vec3 &a = s.set.perturbed[c[1]], &b = s.set.perturbed[c[2]], &d = s.set.perturbed[c[3]];
    const double product = (a - b).norm() * (b - d).norm() * (d - a).norm();
    const double radius = product / (2 * (b - a).cross(d - a).norm());
    const double spacing =
        std::max({s.geometry.spacing[c[1]], s.geometry.spacing[c[2]], s.geometry.spacing[c[3]]});
    EXPECT_TRUE(
        narrow_facet(l.labelling, s.set.perturbed, static_cast<Index>(t), 0, 1.001 * radius / spacing));
    EXPECT_FALSE(
        narrow_facet(l.labelling, s.set.perturbed, static_cast<Index>(t), 0, 0.999 * radius / spacing));
  }
}

TEST(Narrow, PartsAreSortedBySizeAndWithin) {
  const std::vector<Move> parts = smallest_first({{9, 3, 5}, {8}, {2, 1}, {7}, {0, 4}});
  EXPECT_EQ(parts, (std::vector<Move>{{8}, {7}, {1, 2}, {0, 4}, {3, 5, 9}}));
}

}  // namespace
}  // namespace filmsticking
