// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/dense_film.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <vector>

#include "evidence/ball.h"
#include "film/power_complex.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

std::vector<char> film_of(const Setting& s) {
  return dense_film(s.mesh, s.set.perturbed, s.geometry.spacing, 2);
}

TEST(DenseFilm, IsClosedUnderBothOfItsRulesAndTheLargestSuch) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::vector<Point> cloud = test::awkward(seed);
    if (make_site_set(cloud).size() < 5) continue;
    const Setting s(cloud);
    if (s.mesh.size() == 0) continue;
    const std::vector<char> inside = film_of(s);
    const UnsetVector<Index> flow = flow_map(s.mesh, s.set.perturbed);
    // By definition, one tetrahedron at a time and in another order.
    std::vector<char> expected(s.mesh.size(), 1);
    for (bool moved = true; moved;) {
      moved = false;
      for (std::size_t t = s.mesh.size(); t-- > 0;) {
        bool leaves = s.infinite(t) || !expected[flow[t]];
        for (int k = 0; k < 4; ++k) {
          const Index mirror = s.mesh.mirror[t][k];
          leaves = leaves ||
                   (!expected[mirror / 4] &&
                    facet_width(s.mesh, s.set.perturbed, s.geometry.spacing, mirror / 4, mirror % 4) >= 2);
        }
        if (expected[t] && leaves) expected[t] = 0, moved = true;
      }
    }
    EXPECT_EQ(inside, expected) << "seed " << seed;
  }
}

TEST(DenseFilm, EndsTheSameStepByStepAndOnAnyNumberOfThreads) {
  const Setting s(test::torus(3000, 4));
  std::vector<char> one;
  tbb::task_arena(1).execute([&] { one = film_of(s); });
  EXPECT_EQ(one, film_of(s));
  std::vector<std::vector<char>> steps;
  const std::vector<char> watched =
      dense_film(s.mesh, s.set.perturbed, s.geometry.spacing, 2,
                 [&](const std::vector<char>& inside) { steps.push_back(inside); });
  EXPECT_EQ(watched, one);
  ASSERT_GT(steps.size(), 2u);
  EXPECT_EQ(steps.back(), one);
  for (std::size_t k = 1; k < steps.size(); ++k)
    for (std::size_t t = 0; t < one.size(); ++t) EXPECT_LE(steps[k][t], steps[k - 1][t]);
}

// A ball with a round cavity, a tube to it four spacings wide: a film without virtual sites stays outside.
TEST(DenseFilm, EntersACavityThroughAWideMouth) {
  const std::vector<Point> cup = test::box(3000, 5, {1, 1, 1});
  std::vector<Point> points;
  for (const Point& p : cup)
    if (!(p[2] > 0.999 && p[0] > 0.35 && p[0] < 0.65 && p[1] > 0.35 && p[1] < 0.65)) points.push_back(p);
  for (const Point& p : test::box(1200, 6, {0.6, 0.6, 0.6})) {
    const Point q{p[0] + 0.2, p[1] + 0.2, p[2] + 0.2};
    if (!(q[2] > 0.799 && q[0] > 0.35 && q[0] < 0.65 && q[1] > 0.35 && q[1] < 0.65)) points.push_back(q);
  }
  const Setting s(points);
  const std::vector<char> inside = film_of(s);
  const PowerComplex complex(s.set.perturbed, s.mesh.tets);
  EXPECT_FALSE(inside[complex.locate(s.set.to_unit({0.5, 0.5, 0.5}), 0)]);
}

}  // namespace
}  // namespace filmsticking
