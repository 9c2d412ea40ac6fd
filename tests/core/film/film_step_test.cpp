// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/film_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "film/initial_surface.h"
#include "geometry/triangle_adjacency.h"
#include "labelling/repair.h"
#include "support/clouds.h"
#include "support/field_setting.h"
#include "support/power_cells.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;
using Complex = std::shared_ptr<const PowerComplex>;

Complex complex_of(const Setting& s) {
  return std::make_shared<const PowerComplex>(s.set.perturbed, s.mesh.tets);
}

// Every directed edge has its reverse as often: the film has no boundary.
void expect_closed(const Surface& surface) {
  std::map<std::pair<Index, Index>, int> edges;
  for (const Corners& t : surface.triangles)
    for (int k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      ++edges[{a, b}], --edges[{b, a}];
    }
  for (const auto& [edge, count] : edges) EXPECT_EQ(count, 0);
}

TEST(FilmStep, EveryFilmIsClosedAndAManifoldOnceRepaired) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const std::vector<Point> cloud = test::awkward(seed);
    if (make_site_set(cloud).size() < 5) continue;
    const Setting s(cloud);
    if (s.mesh.size() == 0) continue;
    const Complex plain = complex_of(s);
    test::Random random(seed);
    LabelledFilm film = film_within(enclosure(bounding_sphere(s.set.perturbed)), plain);
    for (int step = 0; step < 5; ++step) {
      std::vector<double> weights(s.set.size(), 0);
      for (double& w : weights) w = random.below(3) == 0 ? random.uniform(0, 1e-2) : 0;
      const Complex next = step % 2 != 0 ? std::make_shared<const PowerComplex>(s.set.perturbed, weights,
                                                                                TriangulationLimits{})
                                         : plain;
      std::int64_t held = 0;
      film = film_step(film, next, s.geometry.spacing, step % 3 != 0, held);
      expect_closed(film_surface(film, s.set.size()));
      if (film.complex != plain) continue;
      test::LabelSetting labels(s, film.inside);
      repair(labels.labelling);
      EXPECT_TRUE(test::euler_if_manifold(s, labels.inside)) << "seed " << seed << ", step " << step;
    }
  }
}

// Against the paper's step on a film: the facet of a power edge is on the new film if the edge crosses the
// old one. The crossings are counted face by face here. Where each edge crosses at most once, both agree.
TEST(FilmStep, IsThePapersWhereEveryEdgeCrossesOnce) {
  std::vector<Point> points;
  for (const Vec3& p : test::random_sites(500, 2)) points.push_back({p.x(), p.y(), p.z()});
  const Setting s(points);
  Surface sphere = bounding_sphere(s.set.perturbed);
  for (Vec3& p : sphere.positions) p *= 0.4;
  const LabelledFilm film = film_within(enclosure(sphere), complex_of(s));
  const auto crossings = [&](const Vec3& p, const Vec3& q) {
    int count = 0;
    for (std::size_t f = 0; f < sphere.triangles.size(); ++f) {
      const Vec3 a = sphere.corner(static_cast<Index>(f), 0), b = sphere.corner(static_cast<Index>(f), 1),
                 c = sphere.corner(static_cast<Index>(f), 2);
      const auto side = [](const Vec3& u, const Vec3& v, const Vec3& w, const Vec3& x) {
        return (v - u).cross(w - u).dot(x - u) > 0;
      };
      if (side(a, b, c, p) == side(a, b, c, q)) continue;
      const bool first = side(p, q, a, b);
      count += first == side(p, q, b, c) && first == side(p, q, c, a);
    }
    return count;
  };
  int once = 0, twice = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t)
    for (int k = 0; k < 4; ++k) {
      const Index u = s.mesh.tets.neighbours[t][k];
      if (s.mesh.mirror[t][k] < static_cast<Index>(4 * t) + k || s.infinite(t) ||
          s.infinite(static_cast<std::size_t>(u)))
        continue;
      const int count = crossings(s.mesh.circumcentre[t], s.mesh.circumcentre[u]);
      EXPECT_EQ(film.inside[t] != film.inside[u], count % 2 == 1);
      once += count == 1, twice += count == 2;
    }
  EXPECT_GT(once, 100);
  EXPECT_GT(twice, 0) << "edges that cross twice are what the parity is about";
}

// A film that is a ball with a two-layer plate through it that reaches far out. Dual edges outside the ball
// cross the plate twice, so the paper's dual has faces there, in two layers; the labelling has none.
TEST(FilmStep, APlateWithoutThicknessVanishes) {
  std::vector<Point> points = test::sphere(500, 3, {0, 0, 0}, 0.2);
  for (const Point& p : test::sphere(500, 4)) points.push_back(p);
  const Setting s(points);
  const auto in_ball = [](const Vec3& x) { return x.norm() < 0.15; };
  const auto in_plate = [](const Vec3& x) { return std::abs(x.z() - 0.013) < 1e-9 && x.norm() < 2; };
  const Complex plain = complex_of(s);
  const LabelledFilm ball = film_within(in_ball, plain);
  const LabelledFilm both = film_within([&](const Vec3& x) { return in_ball(x) || in_plate(x); }, plain);
  EXPECT_EQ(both.inside, ball.inside);
  int twice = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t)
    for (const Index u : s.mesh.tets.neighbours[t]) {
      if (s.infinite(t) || s.infinite(static_cast<std::size_t>(u))) continue;
      const Vec3 &p = s.mesh.circumcentre[t], &q = s.mesh.circumcentre[u];
      twice += !in_ball(p) && !in_ball(q) && p.norm() < 2 && q.norm() < 2 && p.z() < 0.013 && q.z() > 0.013;
    }
  EXPECT_GT(twice, 10);
}

// Two layers of points at 0.3 spacings: the interior of the plate has its circumcentres beyond the layers.
TEST(FilmStep, MemoryKeepsAPlateThinnerThanTheSpacing) {
  const Setting s(test::box(3000, 2, {1, 1, 0.008}));
  const Complex plain = complex_of(s);
  std::size_t on[2] = {0, 0};
  for (const bool memory : {false, true}) {
    LabelledFilm film = film_within(enclosure(bounding_sphere(s.set.perturbed)), plain);
    std::int64_t held = 0, all_held = 0;
    for (int step = 0; step < 6; ++step) {
      film = film_step(film, plain, s.geometry.spacing, memory, held);
      all_held += held;
    }
    EXPECT_EQ(all_held > 0, memory);
    const std::vector<char> sides = site_sides(film);
    on[memory] = static_cast<std::size_t>(std::count(sides.begin(), sides.end(), kOnFilm));
  }
  EXPECT_GT(on[1], on[0]);
  EXPECT_GT(on[1], s.set.size() * 98 / 100);
}

}  // namespace
}  // namespace filmsticking
