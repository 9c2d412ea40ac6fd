// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/mend.h"

#include <gtest/gtest.h>

#include <cmath>

#include "labelling/reach.h"
#include "labelling/repair.h"
#include "labelling/warp.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(Mend, NeverAddsHandlesOrComponents) {
  std::int64_t tunnels = 0, tears = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    const Setting s(seed % 2 ? test::sphere(120, seed) : test::torus(200, seed));
    test::LabelSetting l(s, test::random_labels(s.mesh, seed));
    const LabelCounts& counts = l.labelling.counts;
    repair(l.labelling);
    warp(l.labelling, test::random_labels(s.mesh, seed + 1000));
    reach(l.labelling);
    const test::Topology before = test::topology(s, l.inside);
    plug_gaps(l.labelling);
    ASSERT_TRUE(euler_if_manifold(s, l.inside));
    EXPECT_LE(test::topology(s, l.inside).handles, before.handles);
    EXPECT_LE(test::topology(s, l.inside).components, before.components);
    mend(l.labelling, s.set.perturbed);
    ASSERT_TRUE(euler_if_manifold(s, l.inside));
    const test::Topology after = test::topology(s, l.inside);
    EXPECT_LE(after.handles, before.handles);
    EXPECT_LE(after.components, before.components);
    EXPECT_EQ((after.handles < before.handles), (counts.tunnels > 0));
    EXPECT_EQ((after.components < before.components), (counts.tears > 0));
    tunnels += counts.tunnels, tears += counts.tears;
    for (std::size_t t = 0; t < l.inside.size(); ++t) EXPECT_FALSE(l.inside[t] && s.infinite(t));
  }
  EXPECT_GT(tunnels, 0);
  EXPECT_GT(tears, 0);
}

TEST(Mend, ATunnelThatNoSamplesLineIsFilled) {
  const test::BentWall wall{0.06, 0.03, 0.025};
  int tunnels = 0, filled = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Setting s(wall.samples(3000, seed));
    test::LabelSetting l(s, test::labels_where(s, [&](const Point& p) { return wall.in(p); }));
    repair(l.labelling);
    ASSERT_GT(tetrahedral_boundary(s.mesh, l.inside).size(), 5000u) << seed;
    if (euler_if_manifold(s, l.inside) != 0) continue;  // the repair filled it, or left more to do
    plug_gaps(l.labelling);
    mend(l.labelling, s.set.perturbed);
    ++tunnels, filled += euler_if_manifold(s, l.inside) == 2;
  }
  EXPECT_GE(tunnels, 3);
  EXPECT_EQ(filled, tunnels);
}

TEST(Mend, ATunnelThatSamplesLineIsKept) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Setting s(test::torus(1500, seed, 1, 0.8));  // its hole is some six spacings wide
    test::LabelSetting l(s, test::labels_where(s, [&](const Point& p) {
                           return std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) < 0.8;
                         }));
    repair(l.labelling);
    ASSERT_GT(tetrahedral_boundary(s.mesh, l.inside).size(), 2500u);
    ASSERT_EQ(euler_if_manifold(s, l.inside), 0);
    plug_gaps(l.labelling);
    mend(l.labelling, s.set.perturbed);
    EXPECT_EQ(euler_if_manifold(s, l.inside), 0);
  }
}

TEST(Mend, ABridgeThatNoSamplesLineIsCut) {
  const test::TwoEllipsoids shape{2.05};
  int bridges = 0, cut = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Setting s(shape.samples(seed));
    // As if they were two ends of one part, and touched twice.
    test::LabelSetting l(s, test::labels_where(s, [&](const Point& p) {
                           const double from_middle = std::abs(p[1]);
                           return shape.in(p) || (std::abs(p[0] - 1.025) < 0.1 && from_middle > 0.1 &&
                                                  from_middle < 0.2 && std::abs(p[2]) < 0.06);
                         }));
    repair(l.labelling);
    if (euler_if_manifold(s, l.inside) != 0) continue;  // there are not two
    plug_gaps(l.labelling);
    mend(l.labelling, s.set.perturbed);
    ++bridges, cut += euler_if_manifold(s, l.inside) == 2 && test::topology(s, l.inside).components == 1;
  }
  EXPECT_GE(bridges, 3);
  EXPECT_EQ(cut, bridges);
}

TEST(Mend, ABarThatSamplesLineIsKept) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Setting s(test::torus(800, seed, 1, 0.1));  // a spacing and a half
    test::LabelSetting l(s, test::labels_where(s, [&](const Point& p) {
                           return std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) < 0.1;
                         }));
    repair(l.labelling);
    ASSERT_EQ(euler_if_manifold(s, l.inside), 0) << seed;
    ASSERT_EQ(test::topology(s, l.inside).components, 1) << seed;
    plug_gaps(l.labelling);
    mend(l.labelling, s.set.perturbed);
    EXPECT_EQ(euler_if_manifold(s, l.inside), 0) << seed;
    EXPECT_EQ(test::topology(s, l.inside).components, 1) << seed;
  }
}

TEST(Mend, ATornWallIsJoined) {
  const test::BentWall wall{0.02, 0, 0};  // a spacing
  int torn = 0, joined = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Setting s(wall.samples(5000, seed));
    test::LabelSetting l(
        s, test::labels_where(s, [&](const Point& p) { return wall.in(p) && std::abs(p[0] - 0.5) > 0.03; }));
    repair(l.labelling);
    if (test::topology(s, l.inside).components == 1) continue;  // the repair joined it
    plug_gaps(l.labelling);
    mend(l.labelling, s.set.perturbed);
    ++torn, joined += test::topology(s, l.inside).components == 1;
  }
  EXPECT_GE(torn, 3);
  EXPECT_EQ(joined, torn);
}

// The surface of a cavity was one of its own where the neck of a bottle, four spacings wide, was barred.
TEST(Mend, Regression_AMouthThatIsBarredIsOpened) {
  constexpr double kCavity = 0.6, kTube = 0.16;
  int barred = 0, opened = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Setting s(test::ball_with_cavity(seed, kCavity, kTube));
    test::LabelSetting l(s, test::labels_where(s, [&](const Point& p) {
                           const bool hole =
                               std::hypot(p[0], p[1]) < kTube && p[2] > 0 && std::abs(p[2] - 0.8) > 0.05;
                           return std::hypot(p[0], p[1], p[2]) > kCavity && !hole;
                         }));
    repair(l.labelling);
    if (test::topology(s, l.inside).components == 1) continue;
    plug_gaps(l.labelling);
    mend(l.labelling, s.set.perturbed);
    const test::Topology after = test::topology(s, l.inside);
    ++barred, opened += after.components == 1 && after.handles == 0;
  }
  EXPECT_GE(barred, 5);
  EXPECT_EQ(opened, barred);
}

// Of labels whose surface has two components, mend() leaves both.
void expect_two_stay(const Setting& s, std::vector<char> inside) {
  test::LabelSetting l(s, std::move(inside));
  repair(l.labelling);
  ASSERT_EQ(test::topology(s, l.inside).components, 2);
  plug_gaps(l.labelling);
  mend(l.labelling, s.set.perturbed);
  EXPECT_EQ(test::topology(s, l.inside).components, 2);
}

TEST(Mend, AClosedCavityIsKept) {
  for (const double cavity : {0.3, 0.6, 0.85})  // the wall is two spacings thick at least
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(cavity);
      const Setting s(test::ball_with_cavity(seed, cavity, 0));
      expect_two_stay(
          s, test::labels_where(s, [&](const Point& p) { return std::hypot(p[0], p[1], p[2]) > cavity; }));
    }
}

TEST(Mend, PartsCloseToEachOtherStayApart) {
  const test::TwoEllipsoids shape{2.11};  // one and a half spacings away
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    const Setting s(shape.samples(seed));
    expect_two_stay(s, test::labels_where(s, [&](const Point& p) { return shape.in(p); }));
  }
}

// Labels of an open surface may have infinite tetrahedra inside, which have facets of no size: here all of
// them, around a shell that is outside, and a core that is.
TEST(Mend, Regression_NothingInfiniteBarsACavity) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    std::vector<Point> points = test::ball_with_cavity(seed, 0.6, 0);
    for (const Point& p : test::sphere(300, seed + 2000, {0, 0, 0}, 0.3)) points.push_back(p);
    const Setting s(points);
    std::vector<char> inside = test::labels_where(s, [](const Point& p) {
      const double r = std::hypot(p[0], p[1], p[2]);
      return r > 0.3 && r < 0.6;
    });
    for (std::size_t t = 0; t < inside.size(); ++t) inside[t] = static_cast<char>(inside[t] || s.infinite(t));
    test::LabelSetting l(s, inside);
    repair(l.labelling);
    ASSERT_EQ(test::topology(s, l.inside).components, 3) << seed;
    plug_gaps(l.labelling);
    mend(l.labelling, s.set.perturbed);
    for (std::size_t t = 0; t < inside.size(); ++t) EXPECT_TRUE(l.inside[t] || !s.infinite(t));
    EXPECT_EQ(test::topology(s, l.inside).components, 3) << seed;
  }
}

// Of an open surface, sites may be singular and infinite tetrahedra inside: these stay so, and nothing fails.
TEST(Mend, InfiniteTetrahedraKeepTheirLabelsBesideExemptSites) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Setting s(seed % 2 ? test::sphere(120, seed) : test::torus(200, seed));
    test::Random random(seed);
    std::vector<char> inside(s.mesh.size());
    for (char& label : inside) label = random.below(2) > 0;
    std::vector<char> exempt(s.set.size());
    for (char& site : exempt) site = random.below(3) == 0;
    test::LabelSetting l(s, inside);
    repair(l.labelling, exempt);
    const std::vector<char> before = l.inside;
    plug_gaps(l.labelling);
    mend(l.labelling, s.set.perturbed);
    for (std::size_t t = 0; t < inside.size(); ++t)
      EXPECT_TRUE(l.inside[t] == before[t] || !s.infinite(t)) << seed;
  }
}

}  // namespace
}  // namespace filmsticking
