// SPDX-License-Identifier: GPL-3.0-or-later
#include "cutter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "delaunay/delaunay.h"
#include "support/cloud_setting.h"
#include "support/clouds.h"
#include "support/surfaces.h"

namespace filmsticking {
namespace {

struct Bench : test::CloudSetting {
  Cutter cutter;

  explicit Bench(std::vector<Point> cloud)
      : CloudSetting(std::move(cloud)), cutter(view, sites, geometry, options, monitor) {
    cutter.take(delaunay_tetrahedra(sites.perturbed));
  }

  // 1 where `inside` holds for the middle of a tetrahedron.
  template <class Inside>
  std::vector<double> belief(const Inside& inside) const {
    std::vector<double> belief(cutter.mesh().size(), -1);
    for (std::size_t t = 0; t < belief.size(); ++t) {
      if (cutter.mesh().tets.infinite(static_cast<Index>(t))) continue;
      Vec3 middle = Vec3::Zero();
      for (const Index v : cutter.mesh().tets.corners[t]) middle += sites.perturbed[v] / 4;
      const Point p = sites.to_input(middle);
      belief[t] = inside(p) ? 1 : -1;
    }
    return belief;
  }
};

bool in_ball(const Point& p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] < 0.999; }

void expect_closed(const Candidate& candidate) {
  ASSERT_FALSE(candidate.empty());
  EXPECT_TRUE(test::check(candidate.surface).ok());
  EXPECT_TRUE(std::isfinite(candidate.energy));
}

TEST(Cutter, ATrueBeliefGivesTheSurface) {
  Bench ball(test::sphere(2000, 1));
  const Candidate cut = ball.cutter.cut(ball.belief(in_ball), kConviction, false);
  expect_closed(cut);
  EXPECT_EQ(cut.missed, 0);
  EXPECT_EQ(cut.quality.off, 0);
  EXPECT_EQ(cut.quality.complexity, 1);
  EXPECT_EQ(cut.surface.site.size(), ball.sites.size());
}

TEST(Cutter, ABeliefWithoutAnInsideGivesNothing) {
  Bench ball(test::sphere(1000, 2));
  const Candidate cut = ball.cutter.cut(ball.belief([](const Point&) { return false; }), kConviction, false);
  EXPECT_TRUE(cut.empty());
  EXPECT_TRUE(std::isinf(cut.energy));
  EXPECT_EQ(cut.missed, 1);
  EXPECT_TRUE(ball.cutter.refined(cut).empty());
  EXPECT_TRUE(ball.cutter.mended(cut).empty());
}

// Every belief, on walls of half a spacing to two.
TEST(Cutter, RefiningNeverRaisesTheEnergyAndMendingNeverTheHandles) {
  for (const double thickness : {0.5, 1.0, 2.0}) {
    const std::vector<Point> plate = test::box(1500, 7, {1, 1, thickness * std::sqrt(2.0 / 1500)});
    for (const double width : {1.5, 2.0, 4.0}) {
      SCOPED_TRACE(std::to_string(thickness) + " " + std::to_string(width));
      Bench bench(plate);
      const Candidate cut = bench.cutter.cut_ball(width, 0.5, false);
      if (cut.empty()) continue;
      expect_closed(cut);
      bench.cutter.use_normals_of(cut.surface);
      const Candidate mended = bench.cutter.mended(cut);
      expect_closed(mended);
      EXPECT_LE(mended.quality.complexity, cut.quality.complexity);
      const Candidate refined = bench.cutter.refined(cut);
      expect_closed(refined);
      EXPECT_LE(refined.energy, cut.energy);
    }
  }
}

TEST(Cutter, ARimIsOpenOnlyIfItMayBe) {
  std::vector<Point> cap;
  for (const Point& p : test::sphere(3000, 8))
    if (p[2] > 0.2) cap.push_back(p);
  Bench bench(cap);
  EXPECT_TRUE(test::check(bench.cutter.cut_sides(nullptr, false).surface).ok());
  const Candidate open = bench.cutter.cut_sides(nullptr, true);
  EXPECT_FALSE(test::check(open.surface).closed);
  EXPECT_TRUE(open.open);
}

TEST(Cutter, AFilmIsDrawnTowardsItsAimWithoutAChangeOfTopology) {
  Bench torus(test::torus(2000, 3));
  const Candidate cut = torus.cutter.cut_ball(2, 0.5, false);
  expect_closed(cut);
  Candidate film = torus.cutter.by_film(cut.labels, torus.cutter.evidence().cost);
  expect_closed(film);
  const std::int64_t complexity = film.quality.complexity;
  const std::vector<char> nothing(torus.cutter.mesh().size(), 0);
  film = torus.cutter.warped(std::move(film), nothing);
  expect_closed(film);
  EXPECT_EQ(film.quality.complexity, complexity);
}

TEST(Cutter, TheLastResortIsOneTetrahedronAtLeast) {
  Bench four({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const Candidate last = four.cutter.around_one_tetrahedron();
  EXPECT_EQ(last.surface.triangles.size(), 4U);
  EXPECT_TRUE(test::check(last.surface).ok());
}

}  // namespace
}  // namespace filmsticking
