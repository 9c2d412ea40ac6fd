// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/film.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <vector>

#include "film/initial_surface.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

/// An evolution from the bounding sphere, and what it recorded.
struct Evolved {
  std::vector<char> inside;
  std::vector<StepRecord> records;
  std::int64_t on = 0;

  Evolved(const Setting& s, FilmOptions options) {
    options.after_step = [this](const StepRecord& record, const LabelledFilm&) { records.push_back(record); };
    inside = evolve_film(enclosure(bounding_sphere(s.set.perturbed)), s.mesh, s.set.perturbed,
                         s.geometry.spacing, options);
    on = records.empty() ? 0 : records.back().attracted;
  }
};

TEST(Film, ReachesEverySiteOfASphereAndIsAFixedPoint) {
  const Setting s(test::sphere(2000, 5));
  const Evolved run(s, {});
  EXPECT_EQ(run.on, 2000);
  FilmOptions options;
  options.max_steps = 2;
  EXPECT_EQ(evolve_film(run.inside, s.mesh, s.set.perturbed, s.geometry.spacing, options), run.inside);
}

// A sphere in a sphere, unconnected: plain steps stall on the outer one.
TEST(Film, WeightsAttractWhatAStalledFilmLeaves) {
  auto points = test::sphere(1500, 6);
  for (const Point& p : test::sphere(300, 7, {0, 0, 0}, 0.6)) points.push_back(p);
  const Setting s(points);
  FilmOptions plain;
  plain.weights = false;
  const Evolved stalled(s, plain), weighted(s, {});
  EXPECT_LT(stalled.on, 1800);
  EXPECT_GT(
      std::max_element(weighted.records.begin(), weighted.records.end(),
                       [](const StepRecord& a, const StepRecord& b) { return a.attracted < b.attracted; })
          ->attracted,
      stalled.on);
}

// A torus whose bore a film spans at first.
TEST(Film, VirtualSitesLeaveAndTakeFewerSteps) {
  const Setting s(test::torus(3000, 8));
  FilmOptions options;
  options.virtual_sites = 300;
  const Evolved run(s, options);
  std::int64_t left = 300;
  for (const StepRecord& record : run.records) {
    EXPECT_LE(record.virtual_left, left);
    left = record.virtual_left;
  }
  EXPECT_LT(left, 300);
  EXPECT_GT(run.on, 2980);
}

TEST(Film, KeepsMaxStepsAndCancels) {
  const Setting s(test::sphere(500, 5));
  FilmOptions options;
  options.max_steps = 3;
  EXPECT_LE(Evolved(s, options).records.size(), 3u);
  const std::atomic<bool> stop{true};
  options.limits.cancel = {&stop};
  EXPECT_THROW(Evolved(s, options), Cancelled);
}

TEST(Film, AnyNumberOfThreadsGivesTheSameLabels) {
  auto points = test::torus(2000, 9);
  for (const Point& p : test::sphere(300, 10, {0, 0, 0}, 0.2)) points.push_back(p);
  const Setting s(points);
  FilmOptions options;
  options.virtual_sites = 200;
  std::vector<char> one;
  tbb::task_arena(1).execute([&] { one = Evolved(s, options).inside; });
  EXPECT_EQ(one, Evolved(s, options).inside);
}

}  // namespace
}  // namespace filmsticking
