// SPDX-License-Identifier: GPL-3.0-or-later
// ManifoldLabels: gaps and cavities.
#include <gtest/gtest.h>

#include <cmath>

#include "labelling/manifold_labels.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

// Of a wall, as flat ones have flat tetrahedra beside them.
double bend(double x, double y) { return 0.2 * (x * x + 1.3 * y * y); }

TEST(ManifoldLabels, ATunnelThatNoSamplesLineIsFilled) {
  // A bent wall, and a gap in both of its sides.
  const double thickness = 0.06;
  int tunnels = 0, filled = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<Point> points;
    for (Point p : test::box(3000, seed, {1, 1, thickness})) {
      if (std::hypot(p[0] - 0.5, p[1] - 0.5) < 0.03) continue;
      p[2] += bend(p[0], p[1]);
      points.push_back(p);
    }
    const Setting s(points);
    std::vector<char> inside = test::labels_where(s, [&](const Point& p) {
      const double z = p[2] - bend(p[0], p[1]);
      return z > 0 && z < thickness && std::hypot(p[0] - 0.5, p[1] - 0.5) > 0.025;
    });
    const LabelCosts costs = costs_of(s);
    ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
    manifold.repair();
    const auto before = euler_if_manifold(s, inside);
    ASSERT_GT(tetrahedral_boundary(s.mesh, inside).size(), 5000u) << seed;
    if (before != 0) continue;  // the repair filled it, or left more to do
    manifold.fill_gaps(s.set.perturbed);
    ++tunnels, filled += euler_if_manifold(s, inside) == 2;
  }
  EXPECT_GE(tunnels, 3);
  EXPECT_EQ(filled, tunnels);
}

TEST(ManifoldLabels, ATunnelThatSamplesLineIsKept) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Setting s(test::torus(1500, seed, 1, 0.8));  // its hole is some six spacings wide
    std::vector<char> inside = test::labels_where(
        s, [&](const Point& p) { return std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) < 0.8; });
    const LabelCosts costs = costs_of(s);
    ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
    manifold.repair();
    ASSERT_GT(tetrahedral_boundary(s.mesh, inside).size(), 2500u);
    ASSERT_EQ(euler_if_manifold(s, inside), 0);
    manifold.fill_gaps(s.set.perturbed);
    EXPECT_EQ(euler_if_manifold(s, inside), 0);
  }
}

TEST(ManifoldLabels, ABridgeThatNoSamplesLineIsCut) {
  int bridges = 0, cut = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<Point> points = test::ellipsoid(1500, seed, 0);
    const std::vector<Point> second = test::ellipsoid(1500, seed + 100, 2.05);
    points.insert(points.end(), second.begin(), second.end());
    const Setting s(points);
    const auto in = [](const Point& p, double x0) {
      return std::pow(p[0] - x0, 2) + std::pow(p[1] / 0.8, 2) + std::pow(p[2] / 0.6, 2) < 1;
    };
    // As if they were two ends of one part, and touched twice.
    std::vector<char> inside = test::labels_where(s, [&](const Point& p) {
      const double off = std::abs(p[1]);
      return in(p, 0) || in(p, 2.05) ||
             (std::abs(p[0] - 1.025) < 0.1 && off > 0.1 && off < 0.2 && std::abs(p[2]) < 0.06);
    });
    const LabelCosts costs = costs_of(s);
    ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
    manifold.repair();
    if (euler_if_manifold(s, inside) != 0) continue;  // there are not two
    manifold.fill_gaps(s.set.perturbed);
    ++bridges, cut += euler_if_manifold(s, inside) == 2 && test::topology(s, inside).components == 1;
  }
  EXPECT_GE(bridges, 3);
  EXPECT_EQ(cut, bridges);
}

TEST(ManifoldLabels, ABarThatSamplesLineIsKept) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Setting s(test::torus(800, seed, 1, 0.1));  // a spacing and a half
    std::vector<char> inside = test::labels_where(
        s, [&](const Point& p) { return std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) < 0.1; });
    const LabelCosts costs = costs_of(s);
    ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
    manifold.repair();
    ASSERT_EQ(euler_if_manifold(s, inside), 0) << seed;
    ASSERT_EQ(test::topology(s, inside).components, 1) << seed;
    manifold.fill_gaps(s.set.perturbed);
    EXPECT_EQ(euler_if_manifold(s, inside), 0) << seed;
    EXPECT_EQ(test::topology(s, inside).components, 1) << seed;
  }
}

TEST(ManifoldLabels, ATornWallIsJoined) {
  const double thickness = 0.02;  // a spacing
  int torn = 0, joined = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    std::vector<Point> points = test::box(5000, seed, {1, 1, thickness});
    for (Point& p : points) p[2] += bend(p[0], p[1]);
    const Setting s(points);
    std::vector<char> inside = test::labels_where(s, [&](const Point& p) {
      const double z = p[2] - bend(p[0], p[1]);
      return z > 0 && z < thickness && std::abs(p[0] - 0.5) > 0.03;
    });
    const LabelCosts costs = costs_of(s);
    ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
    manifold.repair();
    if (test::topology(s, inside).components == 1) continue;  // the repair joined it
    manifold.fill_gaps(s.set.perturbed);
    ++torn, joined += test::topology(s, inside).components == 1;
  }
  EXPECT_GE(torn, 3);
  EXPECT_EQ(joined, torn);
}

// A ball with a round cavity, and a tube from there to outside unless its radius is 0; about 0.08 apart.
std::vector<Point> ball_with_cavity(std::uint64_t seed, double cavity, double tube) {
  std::vector<Point> points;
  const auto add = [&](const Point& p) {
    if (std::hypot(p[0], p[1]) > tube || p[2] < 0) points.push_back(p);
  };
  for (const Point& p : test::sphere(2000, seed)) add(p);
  for (const Point& p : test::sphere(static_cast<int>(2000 * cavity * cavity), seed + 1000))
    add({cavity * p[0], cavity * p[1], cavity * p[2]});
  test::Random random(seed);
  const int around = static_cast<int>(2000 * tube * (1 - cavity) / 2);
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * M_PI * random.uniform(), z = cavity + (1 - cavity) * random.uniform();
    points.push_back({tube * std::cos(angle), tube * std::sin(angle), z});
  }
  return points;
}

// The surface of a cavity was one of its own where the neck of a bottle, four spacings wide, was barred.
TEST(ManifoldLabels, Regression_AMouthThatIsBarredIsOpened) {
  constexpr double kCavity = 0.6, kTube = 0.16;
  int barred = 0, opened = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Setting s(ball_with_cavity(seed, kCavity, kTube));
    std::vector<char> inside = test::labels_where(s, [&](const Point& p) {
      const bool hole = std::hypot(p[0], p[1]) < kTube && p[2] > 0 && std::abs(p[2] - 0.8) > 0.05;
      return std::hypot(p[0], p[1], p[2]) > kCavity && !hole;
    });
    const LabelCosts costs = costs_of(s);
    ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
    manifold.repair();
    if (test::topology(s, inside).components == 1) continue;
    manifold.open_cavities(s.set.perturbed);
    const test::Topology after = test::topology(s, inside);
    ++barred, opened += after.components == 1 && after.handles == 0;
  }
  EXPECT_GE(barred, 5);
  EXPECT_EQ(opened, barred);
}

// Of labels whose surface has two components, a room leaves both.
template <class Room>
void expect_two_stay(const Setting& s, std::vector<char> inside, const Room& room) {
  const LabelCosts costs = costs_of(s);
  ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
  manifold.repair();
  ASSERT_EQ(test::topology(s, inside).components, 2);
  room(manifold);
  EXPECT_EQ(test::topology(s, inside).components, 2);
}

TEST(ManifoldLabels, AClosedCavityIsKept) {
  for (const double cavity : {0.3, 0.6, 0.85})  // the wall is two spacings thick at least
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(cavity);
      const Setting s(ball_with_cavity(seed, cavity, 0));
      expect_two_stay(
          s, test::labels_where(s, [&](const Point& p) { return std::hypot(p[0], p[1], p[2]) > cavity; }),
          [&](ManifoldLabels& manifold) { manifold.open_cavities(s.set.perturbed); });
    }
}

// Labels of an open surface may have infinite tetrahedra inside, which have facets of no size: here all of
// them, around a shell that is outside, and a core that is.
TEST(ManifoldLabels, Regression_NothingInfiniteBarsACavity) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    std::vector<Point> points = ball_with_cavity(seed, 0.6, 0);
    for (const Point& p : test::sphere(300, seed + 2000, {0, 0, 0}, 0.3)) points.push_back(p);
    const Setting s(points);
    std::vector<char> inside = test::labels_where(s, [](const Point& p) {
      const double r = std::hypot(p[0], p[1], p[2]);
      return r > 0.3 && r < 0.6;
    });
    const auto infinite = [&](std::size_t t) { return s.mesh.tets.infinite(static_cast<Index>(t)); };
    for (std::size_t t = 0; t < inside.size(); ++t) inside[t] = static_cast<char>(inside[t] || infinite(t));
    const LabelCosts costs = costs_of(s);
    ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
    manifold.repair();
    ASSERT_EQ(test::topology(s, inside).components, 3) << seed;
    manifold.open_cavities(s.set.perturbed);
    for (std::size_t t = 0; t < inside.size(); ++t) EXPECT_TRUE(inside[t] || !infinite(t));
    EXPECT_EQ(test::topology(s, inside).components, 3) << seed;
  }
}

TEST(ManifoldLabels, PartsCloseToEachOtherStayApart) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    std::vector<Point> points = test::ellipsoid(1500, seed, 0);
    const std::vector<Point> second =
        test::ellipsoid(1500, seed + 100, 2.11);  // one and a half spacings away
    points.insert(points.end(), second.begin(), second.end());
    const Setting s(points);
    const auto in = [](const Point& p, double x0) {
      return std::pow(p[0] - x0, 2) + std::pow(p[1] / 0.8, 2) + std::pow(p[2] / 0.6, 2) < 1;
    };
    expect_two_stay(s, test::labels_where(s, [&](const Point& p) { return in(p, 0) || in(p, 2.11); }),
                    [&](ManifoldLabels& manifold) { manifold.fill_gaps(s.set.perturbed); });
  }
}

// Of an open surface, sites may be singular and infinite tetrahedra inside: these stay so, and nothing fails.
TEST(ManifoldLabels, GapsAreFilledBesideExemptSitesAndInfinity) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Setting s(seed % 2 ? test::sphere(120, seed) : test::torus(200, seed));
    test::Random random(seed);
    std::vector<char> inside(s.mesh.size());
    for (char& label : inside) label = random.below(2) > 0;
    std::vector<char> exempt(s.set.size());
    for (char& site : exempt) site = random.below(3) == 0;
    const LabelCosts costs = costs_of(s);
    ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
    manifold.repair(exempt);
    const std::vector<char> before = inside;
    manifold.fill_gaps(s.set.perturbed);
    for (std::size_t t = 0; t < inside.size(); ++t)
      EXPECT_TRUE(inside[t] == before[t] || !s.mesh.tets.infinite(static_cast<Index>(t))) << seed;
  }
}

}  // namespace
}  // namespace filmsticking
