// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/half_edge_repair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "geometry/triangle_adjacency.h"
#include "support/clouds.h"
#include "support/film_check.h"

namespace filmsticking {
namespace {

// Triangles with random corners from a few sites, glued at random wherever two half-edges agree: the worst
// input that a repair can get.
HalfEdgeComplex random_complex(std::uint64_t seed) {
  test::Random random(seed);
  const int sites = 3 + random.below(12), pairs = 1 + random.below(60);
  HalfEdgeComplex c;
  for (int i = 0; i < pairs; ++i) {
    Index a = random.below(sites), b = random.below(sites), d = random.below(sites);
    if (a == b || b == d || a == d) continue;
    c.site.insert(c.site.end(),
                  {a, b, d, a, d, b});  // a triangle and its back, so that all half-edges can pair
    c.point.insert(c.point.end(), 2, Vec3::Zero());
  }
  c.twin.assign(c.site.size(), kNone);
  std::vector<Index> order(c.site.size());
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(static_cast<int>(i))]);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Index h = order[i];
    for (std::size_t j = i + 1; j < order.size() && c.twin[h] == kNone; ++j) {
      const Index g = order[j];
      if (c.twin[g] == kNone && c.site[g] == c.site[next_in_face(h)] && c.site[next_in_face(g)] == c.site[h])
        c.twin[h] = g, c.twin[g] = h;
    }
  }
  return c;
}

TEST(HalfEdgeRepair, MakesAManifoldOfAnyClosedComplex) {
  int kept = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const HalfEdgeComplex complex = random_complex(seed);
    test::expect_closed(complex);
    test::Random random(seed);
    std::vector<Vec3> positions;
    for (int i = 0; i < 16; ++i) positions.emplace_back(random.uniform(), random.uniform(), random.uniform());
    for (const RingChoice ring : {RingChoice::Smooth, RingChoice::Nearest}) {
      RepairCounts counts;
      const Surface film = surface_of_sites(repair_half_edges(complex, positions, ring, counts), positions);
      if (film.triangles.empty()) continue;
      ++kept;
      test::expect_manifold(film);
    }
  }
  EXPECT_GT(kept, 500);  // the test is about surfaces, not about empty ones
}

TEST(HalfEdgeRepair, LeavesAManifoldAlone) {
  const HalfEdgeComplex tetrahedron{{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3},
                                    {9, 6, 3, 2, 8, 10, 1, 11, 4, 0, 5, 7},
                                    std::vector<Vec3>(4, Vec3::Zero())};
  test::expect_closed(tetrahedron);
  RepairCounts counts;
  const auto triangles = repair_half_edges(tetrahedron, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                           RingChoice::Smooth, counts);
  EXPECT_EQ(triangles.size(), 4u);
  EXPECT_EQ(counts.total(), 0);
}

TEST(HalfEdgeRepair, RoughnessIsThePapersXi) {
  // A flat ring has none; a cube's corner has three right angles with normals 1/sqrt(3) off the mean.
  EXPECT_NEAR(ring_roughness({0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}), 0, 1e-12);
  const double each = 2 - 2 / std::sqrt(3.0);
  EXPECT_NEAR(ring_roughness({0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 3 * M_PI / 2 * each, 1e-12);
}

}  // namespace
}  // namespace filmsticking
