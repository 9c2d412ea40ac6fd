// SPDX-License-Identifier: GPL-3.0-or-later
// The state: its effects and censuses against a count from nothing, and the bounds of its counters.
#include "labelling/labelling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "evidence/signed_field.h"
#include "labelling/mend.h"
#include "labelling/reach.h"
#include "labelling/repair.h"
#include "labelling/sculpt.h"
#include "labelling/unfold.h"
#include "labelling/warp.h"
#include "support/clean_clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

// Settings of sites on a smooth surface and of flat ones.
Setting small_setting(std::uint64_t seed) {
  return Setting(seed % 3 == 0   ? test::sphere(60, seed)
                 : seed % 3 == 1 ? test::torus(80, seed)
                                 : test::box(70, seed, {1, 1, 0.05}));
}

// Labels of every roughness, with beliefs about each tetrahedron.
struct RandomLabels : test::LabelSetting {
  RandomLabels(const Setting& setting, std::uint64_t seed)
      : LabelSetting(setting, test::random_labels(setting.mesh, seed, 1 + static_cast<int>(seed % 8))) {
    test::Random random(seed);
    for (double& h : costs.hold) h = random.uniform(-0.01, 0.01);
  }
};

// Surplus pieces, Euler characteristic with all sheets apart, and cost, counted from nothing.
Effect totals(const test::LabelSetting& l) {
  Effect sum;
  for (const Census& c : test::censuses_by_hand(l.s.mesh, l.inside, l.s.set.size())) {
    sum.surplus += c.surplus();
    sum.euler += c.sheets();
  }
  std::vector<int> met(l.s.set.size(), 0);  // of each site: 1 inside, 2 outside, 3 both
  int facets = 0;
  for (std::size_t t = 0; t < l.inside.size(); ++t) {
    const double hold = l.costs.hold[t];
    sum.cost += l.inside[t] ? std::max(0., -hold) : std::max(0., hold);
    for (int k = 0; k < 4; ++k) {
      const Index v = l.s.mesh.tets.corners[t][k];
      if (v != kNone) met[v] |= l.inside[t] ? 1 : 2;
      if (!l.inside[t] || l.inside[l.s.mesh.tets.neighbours[t][k]]) continue;
      ++facets;
      sum.cost += l.costs.facet[t][k];
    }
  }
  for (std::size_t v = 0; v < met.size(); ++v)
    if (met[v] != 3) sum.cost += l.costs.off[v];
  sum.euler -= facets / 2;
  return sum;
}

void expect_censuses_right(const test::LabelSetting& l) {
  const std::vector<Census> right = test::censuses_by_hand(l.s.mesh, l.inside, l.s.set.size());
  for (std::size_t v = 0; v < right.size(); ++v) {
    ASSERT_EQ(l.labelling.census(static_cast<Index>(v)).inside, right[v].inside) << v;
    ASSERT_EQ(l.labelling.census(static_cast<Index>(v)).outside, right[v].outside) << v;
  }
}

TEST(Labelling, TheEffectOfAMoveIsWhatChangesOnceItIsMade) {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    const Setting s = small_setting(seed);
    RandomLabels l(s, seed);
    if (seed % 2)
      repair(l.labelling);
    else
      l.labelling.take_census();
    test::Random random(seed);
    Effect before = totals(l);
    for (int i = 0; i < 60; ++i) {
      const Move move = test::random_part(s, l.inside, random, 1 + i % 5);
      const std::vector<char> labels = l.inside;
      const Effect e = l.labelling.effect(move);
      ASSERT_EQ(l.inside, labels);
      const double least = l.labelling.least_cost(move, 0);
      ASSERT_EQ(l.inside, labels);
      l.labelling.apply(move);
      const Effect after = totals(l);
      EXPECT_EQ(e.surplus, after.surplus - before.surplus);
      EXPECT_EQ(e.euler, after.euler - before.euler);
      EXPECT_NEAR(e.cost, after.cost - before.cost, 1e-9 * (1 + std::abs(after.cost)));
      EXPECT_LE(least, e.cost + 1e-9);
      before = after;
    }
    expect_censuses_right(l);
  }
}

// Moves of two tetrahedra that share a facet, of any labels, have a shortcut of their own.
TEST(Labelling, TheCensusAfterMovesOfAPairIsThatOfTheStars) {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    const Setting s = small_setting(seed);
    RandomLabels l(s, seed);
    repair(l.labelling);
    test::Random random(seed);
    for (int i = 0; i < 60; ++i) {
      const Index t = random.below(static_cast<int>(s.mesh.size()));
      const Move move{t, s.mesh.tets.neighbours[t][random.below(4)]};
      if (!l.labelling.allowed(move) || l.labelling.effect(move).surplus > 0) continue;
      l.labelling.apply(move);
    }
    expect_censuses_right(l);
  }
}

TEST(Labelling, TheCensusIsThatOfTheStars) {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const Setting s = small_setting(seed);
    RandomLabels l(s, seed);
    const std::vector<Index> singular = l.labelling.take_census();
    expect_censuses_right(l);
    std::vector<Index> right;
    for (Index v = 0; v < static_cast<Index>(s.set.size()); ++v) {
      const Census c = l.labelling.search_star(v);
      EXPECT_EQ(c.inside + c.outside + 1, static_cast<int>(l.labelling.pieces().size()));
      EXPECT_EQ(l.labelling.pieces().back(), l.labelling.star().size());
      if (c.surplus() > 0) right.push_back(v);
    }
    EXPECT_EQ(singular, right) << seed;
  }
}

TEST(Labelling, ARecountRightsTheCensusAfterFlips) {
  const Setting s = small_setting(1);
  RandomLabels l(s, 1);
  l.labelling.take_census();
  test::Random random(1);
  const Move move = test::random_part(s, l.inside, random, 20);
  for (Index t : move) l.labelling.flip(t);
  l.labelling.recount(move);
  expect_censuses_right(l);
}

// A star is first searched as a list; a piece that was met when the list was full was written past its end,
// and what came after it.
TEST(Labelling, Regression_AStarMayBeLongerThanTheListByAPiece) {
  std::vector<Point> points = test::sphere(60, 1);
  points.push_back({0, 0, 0});
  const Setting s(points);
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    test::LabelSetting l(s, test::random_labels(s.mesh, seed, 11));
    l.labelling.take_census();
    expect_censuses_right(l);
  }
}

TEST(Labelling, EveryFlipWhoseEffectAMoveChangesIsConcerned) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Setting s = small_setting(seed);
    RandomLabels l(s, seed);
    repair(l.labelling);
    test::Random random(seed);
    const auto effects = [&] {
      std::vector<Effect> all;
      for (std::size_t t = 0; t < s.mesh.size(); ++t)
        all.push_back(s.infinite(t) ? Effect{} : l.labelling.effect({static_cast<Index>(t)}));
      return all;
    };
    for (int i = 0; i < 20; ++i) {
      const Move move = test::random_part(s, l.inside, random, 1 + i % 2);
      const std::vector<Effect> before = effects();
      const std::vector<Census> censuses = l.labelling.apply(move);
      std::vector<char> concerned(s.mesh.size(), 0);
      l.labelling.each_concerned(move, censuses, [&](Index t) { concerned[t] = 1; });
      const std::vector<Effect> after = effects();
      for (std::size_t t = 0; t < s.mesh.size(); ++t)
        if (before[t].surplus != after[t].surplus || before[t].euler != after[t].euler ||
            before[t].cost != after[t].cost) {
          ASSERT_TRUE(concerned[t]) << seed << ' ' << t;
        }
    }
  }
}

TEST(Labelling, AroundAnEdgeAreTheTetrahedraThatHaveIt) {
  const Setting s = small_setting(4);
  test::LabelSetting l(s, test::random_labels(s.mesh, 4));
  for (std::size_t i = 0; i < s.mesh.size(); i += 7) {
    const Index t = static_cast<Index>(i);
    const Index v = s.mesh.tets.corners[i][1], w = s.mesh.tets.corners[i][3];
    std::vector<Index> around, right;
    l.labelling.around_edge(t, 1, 3, [&](Index u) { return around.push_back(u), true; });
    for (std::size_t u = 0; u < s.mesh.size(); ++u) {
      const auto& c = s.mesh.tets.corners[u];
      const auto has = [&](Index x) { return std::find(c.begin(), c.end(), x) != c.end(); };
      if (u != i && has(v) && has(w)) right.push_back(static_cast<Index>(u));
    }
    std::sort(around.begin(), around.end());
    EXPECT_EQ(around, right);
    const auto inside = std::count_if(right.begin(), right.end(), [&](Index u) { return l.inside[u]; });
    EXPECT_EQ(l.labelling.mixed(t, 1, 3), inside > 0 && inside < static_cast<std::ptrdiff_t>(right.size()));
  }
}

TEST(Labelling, ARestoreBringsAllBackButTheVisits) {
  const Setting s = small_setting(1);
  RandomLabels l(s, 1);
  std::vector<char> exempt(s.set.size(), 0);
  exempt[0] = 1;
  l.labelling.exempt(exempt);
  l.labelling.take_census();
  const std::vector<char> before = l.inside;
  const std::int64_t visits = l.labelling.counts.visits;
  Labelling::Snapshot snapshot = l.labelling.snapshot();
  repair(l.labelling);
  ASSERT_NE(l.inside, before);
  const std::int64_t more = l.labelling.counts.visits;
  EXPECT_GT(more, visits);
  l.labelling.restore(snapshot);
  EXPECT_EQ(l.inside, before);
  expect_censuses_right(l);
  EXPECT_EQ(l.labelling.counts.repairs, 0);
  EXPECT_EQ(l.labelling.counts.visits, more);
}

// Labels of a cut by the evidence alone.
struct CutSetting : Setting {
  LabelCosts costs;
  std::vector<char> cut;

  explicit CutSetting(const std::vector<Point>& points) : Setting(points), costs(costs_of(*this)) {
    const auto belief = signed_field(mesh, evidence, geometry, std::vector<double>(mesh.size(), 0));
    for (std::size_t t = 0; t < mesh.size(); ++t)
      for (const double area : evidence.area[t]) costs.hold[t] += 0.1 * area * belief[t];
    cut = Sculptor(mesh, evidence, costs.hold).cut();
  }

  std::int64_t euler(const std::vector<char>& inside) const {
    return euler_if_manifold(*this, inside).value();
  }
  std::int64_t pieces(const std::vector<char>& inside) const {
    std::vector<Index> piece;
    return label_pieces(mesh, inside, piece);
  }
  std::size_t on(const std::vector<char>& inside) const {
    return test::surface_of(*this, inside).site.size();
  }
};

// For any labels.
void expect_bounds(const CutSetting& s, std::vector<char> inside, const std::vector<char>& aim) {
  const std::vector<char> before = inside;
  const auto sites = static_cast<std::int64_t>(s.set.size());
  Labelling labelling(s.mesh, s.geometry, s.costs, inside);
  const LabelCounts& counts = labelling.counts;
  repair(labelling);
  EXPECT_LE(counts.singular, sites);
  EXPECT_EQ(counts.repairs + counts.erosions > 0, counts.singular > 0);
  EXPECT_EQ(test::differences(before, inside) > 0, counts.islands + counts.repairs + counts.erosions > 0);
  EXPECT_LE(counts.erosions, static_cast<std::int64_t>(s.mesh.size()));  // each takes one from the inside

  const std::int64_t apart = test::differences(inside, aim);
  warp(labelling, aim);
  EXPECT_EQ(test::differences(inside, aim), apart - counts.warped);  // one less with each

  unfold(labelling);
  const auto flat = std::count_if(s.mesh.flat.begin(), s.mesh.flat.end(), [](int side) { return side != 0; });
  EXPECT_LE(counts.unfolded, 8 * static_cast<std::int64_t>(flat));

  const std::vector<char> warped = inside;
  reach(labelling);
  EXPECT_LE(counts.reached, 8 * sites);
  EXPECT_EQ(counts.reached > 0, test::differences(warped, inside) > 0);

  const std::int64_t euler = s.euler(inside), pieces = s.pieces(inside);
  plug_gaps(labelling);
  mend(labelling, s.set.perturbed);
  // Of a surface, pieces of both labels are components and one more; Euler's characteristic is twice what
  // there are more components than handles. A mend leaves neither more pieces nor, in sum, as many.
  const std::int64_t fewer_pieces = pieces - s.pieces(inside),
                     fewer_handles = (s.euler(inside) - euler) / 2 + fewer_pieces;
  EXPECT_GE(fewer_pieces, counts.tears);
  EXPECT_GE(fewer_handles + fewer_pieces, counts.tunnels + counts.tears);
}

TEST(LabelCounts, KeepTheirBoundsForAnyLabels) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    const CutSetting s(seed % 2 ? test::sphere(150, seed) : test::torus(250, seed));
    expect_bounds(s, test::random_labels(s.mesh, seed, 2), test::random_labels(s.mesh, seed + 1000));
  }
}

TEST(LabelCounts, AreSmallOnCleanClouds) {
  for (const auto& [name, points] : test::clean_clouds()) {
    SCOPED_TRACE(name);
    const CutSetting s(points);
    const double sites = static_cast<double>(s.set.size());
    std::vector<char> inside = s.cut;
    Labelling labelling(s.mesh, s.geometry, s.costs, inside);
    repair(labelling);
    warp(labelling, s.cut);
    reach(labelling);
    plug_gaps(labelling);
    mend(labelling, s.set.perturbed);
    const LabelCounts& c = labelling.counts;
    // The cut of points that are dense beside the shape's features is one already; chance leaves a point or
    // two off.
    EXPECT_LE(static_cast<double>(c.singular), sites / 500);
    EXPECT_LE(c.repairs, 2 * c.singular);
    EXPECT_EQ(c.islands, 0);
    EXPECT_EQ(c.erosions, 0);
    EXPECT_EQ(c.tunnels, 0);
    EXPECT_EQ(c.tears, 0);
    EXPECT_LE(static_cast<double>(c.reached), sites / 200);
    EXPECT_EQ(s.on(inside), s.set.size());
  }
}

}  // namespace
}  // namespace filmsticking
