// SPDX-License-Identifier: GPL-3.0-or-later
#include "film_method.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "delaunay/delaunay.h"
#include "support/cloud_setting.h"
#include "support/clouds.h"
#include "support/surfaces.h"

namespace filmsticking {
namespace {

// The candidate that the paper's method gives, and the report of it.
std::pair<Candidate, Report> film(const std::vector<Point>& points, Options options) {
  options.method = Method::Film;
  test::CloudSetting s(points, options);
  Cutter cutter(s.view, s.sites, s.geometry, s.options, s.monitor);
  cutter.take(delaunay_tetrahedra(s.sites.perturbed));
  s.report.tetrahedra = static_cast<std::int64_t>(cutter.mesh().size());
  Candidate found = FilmMethod(cutter, s.sites, s.geometry, s.options, s.monitor, s.report).run();
  return {std::move(found), s.report};
}

TEST(FilmMethod, AFilmSticksToAllPoints) {
  for (const auto& points : {test::sphere(800, 1), test::torus(1200, 2)}) {
    const auto [found, report] = film(points, {});
    EXPECT_TRUE(test::check(found.surface).ok());
    EXPECT_GE(found.surface.site.size(), points.size() - 2);
    EXPECT_FALSE(report.steps.empty());
  }
}

// A round is kept only if it lowers the energy.
TEST(FilmMethod, RoundsOfFieldAndCutNeverRaiseTheEnergy) {
  for (const FieldMethod field : {FieldMethod::Poisson, FieldMethod::Sculpt}) {
    Options options, alone;
    options.field = field, alone.field = FieldMethod::None;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const auto points = test::box(800, seed, {1, 1, 0.1});
      const Candidate with = film(points, options).first, without = film(points, alone).first;
      EXPECT_TRUE(test::check(with.surface).ok());
      EXPECT_LE(with.energy, without.energy);
    }
  }
}

TEST(FilmMethod, StopsAtTheMostSteps) {
  Options options;
  options.max_steps = 2;
  options.field = FieldMethod::None;
  const auto [found, report] = film(test::torus(1000, 3), options);
  EXPECT_LE(report.steps.size(), 2U);
  EXPECT_TRUE(test::check(found.surface).ok());
}

}  // namespace
}  // namespace filmsticking
