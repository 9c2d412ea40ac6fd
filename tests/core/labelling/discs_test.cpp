// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/discs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "labelling/mend.h"
#include "labelling/repair.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

// All that is outside within this distance of the z axis, where `in` says so.
template <class In>
Move outside_where(const test::LabelSetting& l, const In& in) {
  Move part;
  for (std::size_t t = 0; t < l.inside.size(); ++t)
    if (!l.s.infinite(t) && !l.inside[t] && in(l.s.set.to_input(l.s.centre(t))))
      part.push_back(static_cast<Index>(t));
  return part;
}

TEST(Discs, TheLiningTellsABoreFromAChanceGap) {
  double lined = 0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Setting bored(test::ball_with_cavity(seed, 0.6, 0.16));
    test::LabelSetting ball(bored, test::labels_where(bored, [](const Point& p) {
                              const bool tube = std::hypot(p[0], p[1]) < 0.16 && p[2] > 0;
                              return std::hypot(p[0], p[1], p[2]) > 0.6 && !tube;
                            }));
    repair(ball.labelling);
    const Move bore = outside_where(
        ball, [](const Point& p) { return std::hypot(p[0], p[1]) < 0.16 && std::abs(p[2] - 0.8) < 0.05; });
    lined += lining(ball.labelling, bored.set.perturbed, bore);

    const test::BentWall wall{0.06, 0.06, 0.05};
    const Setting gapped(wall.samples(3000, seed));
    test::LabelSetting gap(gapped, test::labels_where(gapped, [&](const Point& p) { return wall.in(p); }));
    repair(gap.labelling);
    const Move disc = outside_where(gap, [](const Point& p) {
      const double z = p[2] - test::BentWall::bend(p[0], p[1]);
      return test::BentWall::from_middle(p) < 0.07 && z > 0.01 && z < 0.05;
    });
    EXPECT_LT(lining(gap.labelling, gapped.set.perturbed, disc), 0) << seed;
  }
  EXPECT_GT(lined, 5);
}

TEST(Discs, LeaveAllAsItIsAndEachLeavesAHandleLess) {
  int found = 0, mended = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const test::BentWall wall{0.06, 0.03, 0.025};
    const Setting s(wall.samples(3000, seed));
    test::LabelSetting l(s, test::labels_where(s, [&](const Point& p) { return wall.in(p); }));
    repair(l.labelling);
    const test::Topology before = test::topology(s, l.inside);
    if (before.handles == 0) continue;
    const std::vector<char> labels = l.inside;
    const LabelCounts counts = l.labelling.counts;
    Mending mending(l.labelling);
    mending.name_pieces();
    const std::vector<Disc> all = discs(mending, s.set.perturbed, 3, 0);
    EXPECT_EQ(l.inside, labels);
    EXPECT_EQ(l.labelling.counts.tunnels, counts.tunnels);
    EXPECT_EQ(l.labelling.counts.warped, counts.warped);
    EXPECT_GT(l.labelling.counts.visits, counts.visits);
    for (const Disc& disc : all) {
      for (Index t : disc.part) EXPECT_FALSE(l.inside[t] || s.infinite(t));
      ++found;
    }
    if (all.empty()) continue;
    mending.try_all({all[0].part}, 0, {1e100});
    EXPECT_LT(test::topology(s, l.inside).handles, before.handles) << seed;
    ++mended;
  }
  EXPECT_GT(found, 0);
  EXPECT_GT(mended, 0);
}

// The tetrahedra around one edge are as many as the sites; the search for threads walked around it for each
// of them.
TEST(Discs, Regression_TheSearchForThreadsIsBounded) {
  std::vector<Point> points{{0, 0, 0.05}, {0, 0, -0.05}};
  const int n = 4000;
  for (int i = 0; i < n; ++i) points.push_back({std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 0});
  for (const Point& p : test::torus(300, 1, 0.1, 0.04)) points.push_back({p[0] + 3, p[1], p[2]});
  const Setting s(points);
  test::LabelSetting l(s, test::random_labels(s.mesh, 1));
  repair(l.labelling);
  plug_gaps(l.labelling);
  mend(l.labelling, s.set.perturbed);
  EXPECT_TRUE(euler_if_manifold(s, l.inside));
  EXPECT_LE(l.labelling.counts.visits, 11000 * static_cast<std::int64_t>(points.size()));
}

}  // namespace
}  // namespace filmsticking
