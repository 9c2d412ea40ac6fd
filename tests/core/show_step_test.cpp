// SPDX-License-Identifier: GPL-3.0-or-later
#include "show_step.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "support/clouds.h"
#include "support/surfaces.h"

namespace filmsticking {
namespace {

TEST(ShowStep, TheCallerSeesHisOwnCoordinates) {
  std::vector<Point> points;
  for (const Point& p : test::sphere(200, 1)) points.push_back({100 + 7 * p[0], 7 * p[1], 7 * p[2]});
  const SiteSet sites = make_site_set(points);
  Report report;
  report.steps.resize(3);
  Execution execution;
  int step = -1;
  Mesh shown;
  execution.on_step = [&](int number, const Mesh& mesh) { step = number, shown = mesh; };
  const Monitor monitor(execution, report);
  show_step(test::surface_of(sites.perturbed, {{0, 1, 2}}), sites, monitor, report);
  EXPECT_EQ(step, 3);
  ASSERT_EQ(shown.positions.size(), points.size());
  EXPECT_EQ(shown.triangles.size(), 1U);
  for (const Point& p : shown.positions) EXPECT_NEAR(p[0], 100, 7.001);
}

TEST(ShowStep, WithoutAListenerNothingHappens) {
  const std::vector<Point> points = test::sphere(20, 1);
  Report report;
  const Execution execution;
  show_step(test::ball(), make_site_set(points), Monitor(execution, report), report);
}

TEST(ShowStep, WhatTheCallerThrowsIsHisOwn) {
  const std::vector<Point> points = test::sphere(20, 1);
  Report report;
  Execution execution;
  execution.on_step = [](int, const Mesh&) { throw std::runtime_error("enough"); };
  EXPECT_THROW(show_step(test::ball(), make_site_set(points), Monitor(execution, report), report),
               CallbackThrew);
}

}  // namespace
}  // namespace filmsticking
