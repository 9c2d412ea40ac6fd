// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/two_sides.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

std::vector<double> sides_of(const Setting& s, const Vec3* viewpoint = nullptr) {
  return two_sides(s.mesh, s.set.perturbed, s.evidence, s.geometry, viewpoint);
}

TEST(TwoSides, OfAClosedSurfaceAreItsInsideAndOutside) {
  const Setting s(test::torus(3000, 1));
  const std::vector<double> side = sides_of(s);
  int right = 0, all = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    EXPECT_EQ(std::abs(side[t]), 1);
    if (s.infinite(t)) {
      ++all, right += side[t] < 0;
      continue;
    }
    const Point p = s.set.to_input(s.centre(t));
    const double level = std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) - 0.4;
    if (std::abs(level) < 0.05) continue;  // near the surface both are right
    ++all, right += (side[t] > 0) == (level < 0);
  }
  EXPECT_GT(all, 100);
  EXPECT_GT(right, 0.99 * all);
}

// The lower half of a sphere: a bowl, open to +z.
std::vector<Point> bowl(std::uint64_t seed) {
  std::vector<Point> points;
  for (Point p : test::sphere(6000, seed)) points.push_back({p[0], p[1], -std::abs(p[2])});
  return points;
}

// Both sides of an open surface reach infinity. Facets of the surface away from its rim have different sides
// before and behind them, and most such surfaces face one way everywhere.
TEST(TwoSides, OfAnOpenSurfaceDifferAcrossIt) {
  int coherent = 0;
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    const Setting s(bowl(seed));
    const std::vector<double> side = sides_of(s);
    double differ = 0, within = 0, total = 0;
    for (std::size_t t = 0; t < s.mesh.size(); ++t)
      for (int k = 0; k < 4; ++k) {
        if (s.evidence.votes[t][k] < 3) continue;
        const auto& c = s.mesh.tets.corners[t];
        const Vec3 &a = s.set.perturbed[c[kFacet[k][0]]], &b = s.set.perturbed[c[kFacet[k][1]]],
                   &d = s.set.perturbed[c[kFacet[k][2]]];
        const Point p = s.set.to_input(a);  // from the middle of the sphere
        if (p[2] > -0.3 || (b - a).cross(d - a).dot(Vec3(p[0], p[1], p[2])) < 0) continue;  // t is below
        const double area = s.evidence.area[t][k];
        differ += side[t] != side[s.mesh.tets.neighbours[t][k]] ? area : 0;
        within += side[t] * area, total += area;
      }
    EXPECT_GT(total, 0.5) << seed;
    EXPECT_GT(differ, 0.95 * total) << seed;
    coherent += std::abs(within) > 0.9 * total;
  }
  EXPECT_GE(coherent, 2);
}

// The side that has more of the hull is outside.
TEST(TwoSides, MoreOfTheHullIsOutside) {
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    const Setting s(bowl(seed));
    const std::vector<double> side = sides_of(s);
    double hull = 0;
    for (std::size_t t = 0; t < s.mesh.size(); ++t)
      if (s.infinite(t))
        for (const double area : s.evidence.area[t]) hull += side[t] * area;
    EXPECT_LE(hull, 0) << seed;
  }
}

// A viewpoint joins what little else joins: three plates that do not touch face it alike.
TEST(TwoSides, FaceAViewpointAlike) {
  std::vector<Point> points;
  for (int i = 0; i < 3; ++i) {
    test::Random random(static_cast<std::uint64_t>(i));
    for (int k = 0; k < 1500; ++k) {
      const double x = random.uniform(), y = random.uniform();
      points.push_back({x + 3 * i, y, 0.1 * (x * x + 1.3 * y * y)});
    }
  }
  const Setting s(points);
  const Vec3 viewpoint = s.set.to_unit({4, 0.5, 30});
  const std::vector<double> side = sides_of(s, &viewpoint);
  double above[3] = {0, 0, 0}, total[3] = {0, 0, 0};
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.infinite(t)) continue;
    for (int k = 0; k < 4; ++k) {
      if (s.evidence.votes[t][k] < 3) continue;
      const auto& c = s.mesh.tets.corners[t];
      const Vec3 &a = s.set.perturbed[c[kFacet[k][0]]], &b = s.set.perturbed[c[kFacet[k][1]]],
                 &d = s.set.perturbed[c[kFacet[k][2]]];
      if ((b - a).cross(d - a)[2] >= 0) continue;  // t is above the facet
      const int plate = static_cast<int>(std::floor((s.set.to_input(a)[0] + 1) / 3));
      above[plate] += side[t] * s.evidence.area[t][k], total[plate] += s.evidence.area[t][k];
    }
  }
  for (int i = 0; i < 3; ++i) {
    ASSERT_GT(total[i], 0);
    EXPECT_GT(std::abs(above[i]), 0.9 * total[i]) << i;
    EXPECT_GT(above[i] * above[0], 0) << i;
  }
}

}  // namespace
}  // namespace filmsticking
