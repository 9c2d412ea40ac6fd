// SPDX-License-Identifier: GPL-3.0-or-later
// The field methods on the Delaunay tetrahedra.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "evidence/ball.h"
#include "evidence/signed_field.h"
#include "film/film.h"
#include "film/poisson.h"
#include "film/winding_number.h"
#include "labelling/manifold_labels.h"
#include "labelling/minimum_cut.h"
#include "labelling/sculpt.h"
#include "labelling/surface_sheets.h"
#include "support/clouds.h"
#include "support/field_setting.h"
#include "surface/surface_quality.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(TetrahedralMesh, FacetsFaceOutAndMirrorsMatch) {
  const Setting s(test::sphere(300, 1));
  for (std::size_t t = 0; t < s.mesh.size(); ++t)
    for (int k = 0; k < 4; ++k) {
      const Index mirror = s.mesh.mirror[t][k];
      EXPECT_EQ(s.mesh.mirror[mirror / 4][mirror % 4], static_cast<Index>(4 * t) + k);
      if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
      const auto& c = s.mesh.tets.corners[t];
      const Vec3 &a = s.set.perturbed[c[kFacet[k][0]]], &b = s.set.perturbed[c[kFacet[k][1]]],
                 &d = s.set.perturbed[c[kFacet[k][2]]];
      EXPECT_GT((b - a).cross(d - a).dot(a - s.set.perturbed[c[k]]), 0);
      EXPECT_NEAR((s.mesh.circumcentre[t] - s.set.perturbed[c[k]]).norm() / s.mesh.circumradius[t], 1, 1e-6);
    }
}

// Pieces of the tetrahedra at a site, of both labels, joined through facets at the site: one by one.
int pieces_at(const TetrahedralMesh& mesh, const std::vector<char>& inside, Index v) {
  std::vector<Index> star;
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (const Index c : mesh.tets.corners[t])
      if (c == v) star.push_back(static_cast<Index>(t));
  std::vector<char> met(mesh.size(), 1);
  for (const Index t : star) met[t] = 0;
  int pieces = 0;
  for (const Index start : star) {
    if (met[start]) continue;
    ++pieces;
    std::vector<Index> stack{start};
    for (met[start] = 1; !stack.empty();) {
      const Index t = stack.back();
      stack.pop_back();
      for (int k = 0; k < 4; ++k) {
        const Index u = mesh.tets.neighbours[t][k];
        if (mesh.tets.corners[t][k] == v || met[u] || inside[u] != inside[t]) continue;
        met[u] = 1;
        stack.push_back(u);
      }
    }
  }
  return pieces;
}

TEST(SurfaceSheets, AreWhatTheStarsSay) {
  const Setting s(test::torus(250, 3));
  for (int turn = 0; turn < 8; ++turn) {
    std::vector<char> inside = test::random_labels(s.mesh, static_cast<std::uint64_t>(turn));
    if (turn % 2 == 1)  // smooth as well
      for (std::size_t t = 0; t < inside.size(); ++t)
        inside[t] = !s.mesh.tets.infinite(static_cast<Index>(t)) && s.mesh.circumradius[t] < 0.1 * turn;
    const std::vector<Sheets> sheets = surface_sheets(s.mesh, inside, s.set.size());
    for (std::size_t v = 0; v < sheets.size(); ++v) {
      const int pieces = pieces_at(s.mesh, inside, static_cast<Index>(v));
      EXPECT_EQ(sheets[v], pieces == 1 ? Sheets::None : pieces == 2 ? Sheets::Disc : Sheets::Other) << v;
    }
  }
}

// All cuts of small graphs, one by one.
TEST(MinimumCut, IsMinimal) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    test::Random random(seed);
    const int n = 2 * (2 + random.below(4));  // four arcs each: pair the arc ends at random
    std::vector<Index> ends(4 * n);
    for (int i = 0; i < 4 * n; ++i) ends[i] = i;
    for (int i = 4 * n; i > 1; --i) std::swap(ends[i - 1], ends[random.below(i)]);
    UnsetVector<std::array<Index, 4>> mirror(n);
    CutGraph graph{mirror, {}, {}};
    graph.capacity.assign(n, {0, 0, 0, 0});
    for (int i = 0; i < 4 * n; i += 2) {
      const Index a = ends[i], b = ends[i + 1];
      mirror[a / 4][a % 4] = b, mirror[b / 4][b % 4] = a;
      if (a / 4 != b / 4) graph.capacity[a / 4][a % 4] = graph.capacity[b / 4][b % 4] = random.below(20);
    }
    for (int i = 0; i < n; ++i) graph.terminal.push_back(random.below(41) - 20);
    const CutGraph original = graph;
    auto cost = [&](const std::vector<char>& side) {
      std::int64_t sum = 0;
      for (int i = 0; i < n; ++i) {
        if (side[i] != (original.terminal[i] > 0)) sum += std::abs(original.terminal[i]);
        for (int k = 0; k < 4; ++k)
          if (side[i] && !side[mirror[i][k] / 4]) sum += original.capacity[i][k];
      }
      return sum;
    };
    std::int64_t least = INT64_MAX;
    for (int bits = 0; bits < 1 << n; ++bits) {
      std::vector<char> side(n);
      for (int i = 0; i < n; ++i) side[i] = bits >> i & 1;
      least = std::min(least, cost(side));
    }
    EXPECT_EQ(cost(minimum_cut(graph, std::vector<char>(n, 0))), least) << seed;
  }
}

TEST(WindingNumber, IsOneInsideAndNoneOutside) {
  const Setting s(test::sphere(3000, 2));
  std::vector<Vec3> dipoles;
  for (const Vec3& p : s.set.perturbed) dipoles.push_back(p.normalized() * (M_PI / 3000));
  const WindingNumber winding(s.set.perturbed, dipoles);
  test::Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Point d = random.direction();
    const Vec3 v(d[0], d[1], d[2]);
    for (const double radius : {0.4 * random.uniform(), 0.6 + random.uniform()}) {
      const Vec3 x = radius * v;
      double direct = 0;  // without grouping; the samples' own unevenness is in both
      for (std::size_t k = 0; k < dipoles.size(); ++k) {
        const Vec3 to = s.set.perturbed[k] - x;
        direct += dipoles[k].dot(to) / (4 * M_PI * std::pow(to.norm(), 3));
      }
      EXPECT_NEAR(winding(x), direct, 0.04);  // a group is one dipole from 2.3 radii on
      EXPECT_NEAR(winding(x), radius < 0.5 ? 1 : 0, 0.15);
    }
  }
}

TEST(WindingNumber, PlatesLeaveNoTrace) {
  // Two layers over the same sites: the vectors cancel.
  Surface plate;
  plate.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  plate.site = {0, 1, 2, 3};
  plate.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 2, 1}, {1, 2, 3}};
  for (const Vec3& d : film_dipoles(plate, 4)) EXPECT_EQ(d.norm(), 0);
}

TEST(Carve, ReachesTheOutsideAndNoSolid) {
  const Setting s(test::torus(4000, 4));
  const auto width = ball_widths(s.mesh, s.set.perturbed, s.geometry.spacing, 0, 1e9);
  int wrong = 0, deep = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
    const Point x = s.set.to_input(s.mesh.circumcentre[t]);
    const double off = std::hypot(std::hypot(x[0], x[1]) - 1, x[2]) - 0.4;
    if (std::abs(off) < 0.15) continue;  // near the surface both are right
    ++deep;
    wrong += (off < 0) != (width[t] < 2.5);
  }
  EXPECT_GT(deep, 100);
  EXPECT_LT(wrong, deep / 100);
}

TEST(SignedField, KnowsNestedSpheresByParity) {
  auto points = test::sphere(6000, 5);
  for (const Point& p : test::sphere(1500, 6, {0, 0, 0}, 0.5)) points.push_back(p);
  const Setting s(points);
  const auto field = signed_field(s.mesh, s.evidence, std::vector<double>(s.mesh.size(), 0));
  int right = 0, all = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
    const double r = s.centre(t).norm() * 2;
    if (std::abs(r - 1) < 0.1 || std::abs(r - 0.5) < 0.1) continue;
    ++all;
    right += (field[t] > 0) == (r < 1 && r > 0.5);
  }
  EXPECT_GT(right, all * 99 / 100);
}

TEST(Sculpt, FollowsTheEvidenceWhereTheBeliefIsVague) {
  const Setting s(test::sphere(3000, 7));
  std::vector<double> belief(s.mesh.size(), -1);
  for (std::size_t t = 0; t < s.mesh.size(); ++t)
    if (!s.mesh.tets.infinite(static_cast<Index>(t))) belief[t] = s.centre(t).norm() < 0.45 ? 1 : 0;
  std::vector<double> hold(s.mesh.size(), 0);
  for (std::size_t t = 0; t < hold.size(); ++t)
    for (const double area : s.evidence.area[t]) hold[t] += 0.1 * area * belief[t];
  std::vector<char> inside = Sculptor(s.mesh, s.evidence, hold).cut();
  const LabelCosts costs = costs_of(s);
  ManifoldLabels manifold(s.mesh, s.geometry, costs, inside);
  manifold.repair();
  const Surface film = test::film_of(s, inside);
  EXPECT_GT(film.site.size(), 2990u);
  EXPECT_LT(surface_quality(film, s.geometry).disagreement, 0.02);
}

TEST(Sculpt, ACutThatGoesOnIsACutFromTheStart) {
  const Setting s(test::torus(1500, 4));
  test::Random random(5);
  std::vector<double> hold(s.mesh.size());
  for (std::size_t t = 0; t < hold.size(); ++t)
    for (const double area : s.evidence.area[t]) hold[t] += random.uniform(-1, 1) * area;
  for (const bool open : {false, true}) {
    std::vector<double> now = hold;
    Sculptor sculptor(s.mesh, s.evidence, now, open);
    for (int turn = 0; turn < 5; ++turn) {
      const std::vector<char> inside = sculptor.cut();
      EXPECT_GT(std::count(inside.begin(), inside.end(), 1), 0);
      EXPECT_EQ(inside, Sculptor(s.mesh, s.evidence, now, open).cut());
      for (std::size_t t = 0; t < now.size(); ++t) {
        if (random.below(3) > 0) continue;
        const double before = now[t];
        now[t] *= random.uniform(1, 3);
        sculptor.hold_firmly(static_cast<Index>(t), before, now[t]);
      }
    }
  }
}

TEST(Poisson, SeparatesInsideFromOutside) {
  const Setting s(test::sphere(2000, 8));
  std::vector<Vec3> normals;
  for (const Vec3& p : s.set.perturbed) normals.push_back(p.normalized());
  const auto belief = poisson_belief(s.mesh, s.set.perturbed, normals);
  ASSERT_EQ(belief.size(), s.mesh.size());
  int right = 0, all = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t)) || std::abs(s.centre(t).norm() - 0.5) < 0.03) continue;
    ++all;
    right += (belief[t] > 0) == (s.centre(t).norm() < 0.5);
  }
  EXPECT_GT(right, all * 99 / 100);
  EXPECT_TRUE(poisson_belief(s.mesh, s.set.perturbed, std::vector<Vec3>(s.set.size(), Vec3::Zero())).empty());
}

}  // namespace
}  // namespace filmsticking
