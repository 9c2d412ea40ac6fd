// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/delaunay.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "delaunay/canonical_order.h"
#include "delaunay/regular.h"
#include "points/site_set.h"

namespace filmsticking {
namespace {

// CGAL's triangulation.
Tetrahedra reference(const std::vector<Vec3>& sites) {
  return in_canonical_order(regular_tetrahedra(sites, {}), sites.size());
}

std::vector<Vec3> along_curve(const std::vector<Vec3>& points) {
  std::vector<Point> input;
  for (const Vec3& p : points) input.push_back({p.x(), p.y(), p.z()});
  return make_site_set(input).perturbed;
}

struct Cloud {
  std::string name;
  std::vector<Vec3> points;
};

// `n`: points per cloud, about.
std::vector<Cloud> nasty_clouds(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> in(-1, 1);
  std::normal_distribution<double> normal;
  const auto anywhere = [&] { return Vec3(in(random), in(random), in(random)); };
  const auto direction = [&] { return Vec3(normal(random), normal(random), normal(random)).normalized(); };
  const int side = std::max(2, static_cast<int>(std::cbrt(n)));
  std::vector<Cloud> clouds{{"ball", {}},  {"sphere", {}},           {"grid", {}},     {"plate", {}},
                            {"line", {}},  {"one ulp apart", {}},    {"clusters", {}}, {"quantised", {}},
                            {"helix", {}}, {"sphere and centre", {}}};
  for (int i = 0; i < n; ++i) {
    const double s = i / static_cast<double>(n);
    const Vec3 p = anywhere(), d = direction();
    clouds[0].points.push_back(p);
    clouds[1].points.push_back(d);
    clouds[3].points.emplace_back(p.x(), p.y(), 1e-7 * p.z());
    clouds[4].points.emplace_back(s, 1e-6 * p.y(), 1e-6 * p.z());
    clouds[5].points.push_back(p);
    clouds[5].points.emplace_back(std::nextafter(p.x(), 2.0), p.y(), p.z());
    clouds[6].points.push_back(Vec3(i % 3, i % 2, 0) + std::pow(10.0, -(i % 9)) * p);
    clouds[7].points.push_back((p * 50).array().round().matrix());
    clouds[8].points.emplace_back(std::cos(20 * s), std::sin(20 * s), 3 * s + 0.01 * p.z());
    clouds[9].points.push_back(d);
  }
  clouds[9].points.emplace_back(0, 0, 0);
  for (int i = 0; i < side * side * side; ++i)
    clouds[2].points.emplace_back(i % side, i / side % side, i / side / side);
  return clouds;
}

void expect_same(const Tetrahedra& a, const Tetrahedra& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_TRUE(a.corners == b.corners);
  EXPECT_TRUE(a.neighbours == b.neighbours);
}

TEST(Delaunay, TetrahedraAreThoseOfCgal) {
  int own = 0, all = 0;
  for (const int n : {4, 5, 8, 30, 300, 3000})
    for (unsigned seed = 0; seed < 6; ++seed)
      for (const Cloud& cloud : nasty_clouds(n, seed)) {
        const std::vector<Vec3> sites = along_curve(cloud.points);
        if (sites.size() < 4) continue;
        SCOPED_TRACE(cloud.name + ", " + std::to_string(n) + " points, seed " + std::to_string(seed));
        ++all;
        Tetrahedra tets;
        if (!incremental_delaunay(sites, tets)) continue;  // a tie: tested below
        ++own;
        expect_same(in_canonical_order(std::move(tets), sites.size()), reference(sites));
      }
  EXPECT_GT(own, all * 9 / 10);
}

TEST(Delaunay, SeveralThreadsMakeTheSameTetrahedra) {
  for (const Cloud& cloud : nasty_clouds(45000, 1)) {
    if (cloud.name == "line" || cloud.name == "plate" || cloud.name == "sphere")
      continue;  // exact arithmetic, mostly: long
    SCOPED_TRACE(cloud.name);
    const std::vector<Vec3> sites = along_curve(cloud.points);
    const Tetrahedra expected = reference(sites);
    for (const int threads : {1, 2}) {
      tbb::task_arena arena(threads);
      Tetrahedra tets;
      if (arena.execute([&] { return incremental_delaunay(sites, tets); }))
        expect_same(in_canonical_order(std::move(tets), sites.size()), expected);
      else
        EXPECT_EQ(tets.size(), 0u);
    }
  }
}

// Slots run out again and again. A slot past the last must not be read as a tetrahedron.
TEST(Delaunay, ManyMoreTetrahedraThanASurfaceHas) {
  std::vector<Vec3> points;  // two curves: every segment of one is in a tetrahedron with many of the other
  for (int i = 0; i < 700; ++i) {
    const double s = i / 700.0;
    points.emplace_back(s, 0.1 * s * s, 0);
    points.emplace_back(0.1 * s * s, 0.5 + s, 1);
  }
  const std::vector<Vec3> sites = along_curve(points);
  const Tetrahedra expected = reference(sites);
  ASSERT_GT(expected.size(), 100 * sites.size());
  expect_same(delaunay_tetrahedra(sites), expected);
}

TEST(Delaunay, MoreTetrahedraThanAllowedAreNotMade) {
  const std::vector<Vec3> sites = along_curve(nasty_clouds(45000, 2)[0].points);
  const auto count = static_cast<std::int64_t>(delaunay_tetrahedra(sites).size());
  const std::atomic<bool> wish{true};
  for (const int threads : {1, 2}) {
    tbb::task_arena arena(threads);
    const auto make = [&](const TriangulationLimits& limits) {
      return arena.execute([&] { return delaunay_tetrahedra(sites, limits).size(); });
    };
    EXPECT_EQ(make({count, {}}), static_cast<std::size_t>(count));
    EXPECT_THROW(make({count - 1, {}}), TooManyTetrahedra);
    EXPECT_THROW(make({count / 3, {}}), TooManyTetrahedra);  // seen on the way
    EXPECT_THROW(make({count, {&wish}}), Cancelled);
  }
}

// If the triangulation is not unique, returning one would depend on the order of the sites.
TEST(Delaunay, TiesAreNoticed) {
  std::vector<Vec3> cube, flat, twice;
  for (int i = 0; i < 8; ++i) cube.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  for (int i = 0; i < 25; ++i) flat.emplace_back(i % 5, i / 5, 0.5 * (i % 5));
  twice = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}};
  Tetrahedra tets;
  for (const auto& sites : {cube, flat, twice}) {
    EXPECT_FALSE(incremental_delaunay(sites, tets));
    EXPECT_EQ(tets.size(), 0u);
  }
  EXPECT_GT(delaunay_tetrahedra(cube).size(), 0u);
  EXPECT_EQ(delaunay_tetrahedra(flat).size(), 0u);
  EXPECT_EQ(delaunay_tetrahedra(twice).size(), 5u);  // one, and four infinite ones
}

}  // namespace
}  // namespace filmsticking
