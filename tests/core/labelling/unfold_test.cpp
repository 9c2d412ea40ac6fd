// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/unfold.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "labelling/repair.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

// A plate on the axes: its sides are flat, and so are the tetrahedra of four samples of one side.
TEST(Unfold, LeavesTheTopology) {
  std::int64_t unfolded = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Setting s(test::box(300, seed, {1, 1, 0.05}));
    EXPECT_GT(std::count_if(s.mesh.flat.begin(), s.mesh.flat.end(), [](int side) { return side != 0; }), 0);
    test::LabelSetting l(s, test::random_labels(s.mesh, seed));
    repair(l.labelling);
    const test::Topology before = test::topology(s, l.inside);
    unfold(l.labelling);
    ASSERT_TRUE(euler_if_manifold(s, l.inside)) << seed;
    const test::Topology after = test::topology(s, l.inside);
    EXPECT_EQ(after.handles, before.handles) << seed;
    EXPECT_EQ(after.components, before.components) << seed;
    unfolded += l.labelling.counts.unfolded;
    const std::int64_t once = l.labelling.counts.unfolded;
    unfold(l.labelling);
    EXPECT_EQ(l.labelling.counts.unfolded, once) << seed;
  }
  EXPECT_GT(unfolded, 0);
}

// Places where the surface of a plate on the axes touches itself: a site of it strictly within a facet of it,
// where all four are corners of a tetrahedron and have the very same height.
int pinches(const Setting& s, const std::vector<Point>& points, const std::vector<char>& inside) {
  std::vector<char> on(s.set.size(), 0);
  for (const Index v : test::surface_of(s, inside).site) on[v] = 1;
  const auto left = [](const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  };
  int count = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.infinite(t)) continue;
    const auto& corners = s.mesh.tets.corners[t];
    const auto at = [&](int k) { return points[s.set.input[corners[k]]]; };
    for (int k = 0; k < 4; ++k) {
      if (!on[corners[k]] || inside[s.mesh.tets.neighbours[t][k]] == inside[t]) continue;
      const Point p = at(k), a = at(kFacet[k][0]), b = at(kFacet[k][1]), c = at(kFacet[k][2]);
      if (p[2] != a[2] || p[2] != b[2] || p[2] != c[2]) continue;
      const double sign = left(a, b, c) < 0 ? -1 : 1;
      count += sign * left(a, b, p) > 0 && sign * left(b, c, p) > 0 && sign * left(c, a, p) > 0;
    }
  }
  return count;
}

// Such were left on plates of half a spacing, where a sample of one side hung from the other: here from the
// facet of a tetrahedron between them, which is taken out.
TEST(Unfold, Regression_ASiteInAFaceGoesOverToItsSheet) {
  int before = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const std::vector<Point> points = test::box(300, seed, {1, 1, 0.1});
    const Setting s(points);
    const std::vector<char> full = test::labels_where(s, [](const Point&) { return true; });
    for (std::size_t t = 0; t < s.mesh.size(); ++t) {
      const auto& beside = s.mesh.tets.neighbours[t];
      if (!full[t] || s.mesh.flat[t] ||
          std::all_of(beside.begin(), beside.end(), [&](Index u) { return full[u]; }))
        continue;
      std::vector<char> inside = full;
      inside[t] = 0;
      test::LabelSetting l(s, inside);
      repair(l.labelling);
      const int now = pinches(s, points, l.inside);
      if (l.labelling.counts.singular > 0 || now == 0) continue;
      before += now;
      unfold(l.labelling);
      ASSERT_TRUE(euler_if_manifold(s, l.inside));
      EXPECT_EQ(pinches(s, points, l.inside), 0) << seed;
    }
  }
  EXPECT_GT(before, 0);
}

}  // namespace
}  // namespace filmsticking
