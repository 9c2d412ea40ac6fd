// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/film.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
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

// A flask whose mouth is too narrow for a film, and a hollow ball: the tetrahedra within are outside at last.
TEST(Film, EntersCavitiesItCannotReach) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    auto hollow = test::sphere(3000, seed);
    for (const Point& p : test::sphere(2000, seed + 50, {0, 0, 0}, 0.8)) hollow.push_back(p);
    const auto flask = test::revolved(
        5000, seed,
        {{0, -1}, {1, -1}, {1, 0.8}, {0.06, 0.95}, {0.06, 0.85}, {0.8, 0.6}, {0.8, -0.8}, {0, -0.8}});
    for (const auto& points : {hollow, flask}) {
      const Setting s(points);
      const Evolved run(s, {});
      EXPECT_GT(run.on, 4500) << "seed " << seed;
      for (std::size_t t = 0; t < s.mesh.size(); ++t)
        EXPECT_FALSE(!s.infinite(t) && s.centre(t).norm() * s.set.side < 0.6 && run.inside[t])
            << "seed " << seed;
    }
  }
}

// A waisted tube whose wall is a twentieth of the spacing thick. Its two sides gave way to each other: 40 %
// of the area was lost.
TEST(Film, Regression_DoesNotDigIntoThinCurvedWalls) {
  std::vector<std::array<double, 2>> profile;
  for (int i = 0; i <= 40; ++i) profile.push_back({std::hypot(0.3, i / 20.0 - 1), i / 20.0 - 1});
  for (int i = 40; i >= 0; --i) profile.push_back({profile[i][0] + 0.003, profile[i][1]});
  profile.push_back(profile.front());
  double truth = 0;
  for (std::size_t i = 1; i < profile.size(); ++i)
    truth += M_PI * (profile[i][0] + profile[i - 1][0]) *
             std::hypot(profile[i][0] - profile[i - 1][0], profile[i][1] - profile[i - 1][1]);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Setting s(test::revolved(5000, seed, profile));
    FilmOptions options;
    options.virtual_sites = 1000;
    const Surface film = film_surface(s.mesh.tets, Evolved(s, options).inside, s.set.perturbed);
    double area = 0;
    for (std::size_t f = 0; f < film.triangles.size(); ++f) {
      const auto corner = [&](int k) { return film.corner(static_cast<Index>(f), k); };
      area += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
    }
    EXPECT_NEAR(area * s.set.side * s.set.side / truth, 1, 0.2) << "seed " << seed;
  }
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
