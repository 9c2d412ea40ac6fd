// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/label_islands.h"

#include <gtest/gtest.h>

#include <set>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(LabelIslands, PiecesAreWhatFacetsConnect) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Setting s(test::torus(200, seed));
    const std::vector<char> inside = test::random_labels(s.mesh, seed);
    std::vector<Index> piece;
    const Index count = label_pieces(s.mesh, inside, piece);
    // Flood fills, in the order of their first tetrahedra.
    std::vector<Index> right(s.mesh.size(), kNone);
    Index pieces = 0;
    for (std::size_t t = 0; t < s.mesh.size(); ++t) {
      if (right[t] != kNone) continue;
      std::vector<Index> stack{static_cast<Index>(t)};
      for (right[t] = pieces; !stack.empty();) {
        const Index at = stack.back();
        stack.pop_back();
        for (Index u : s.mesh.tets.neighbours[at])
          if (right[u] == kNone && inside[u] == inside[at]) right[u] = pieces, stack.push_back(u);
      }
      ++pieces;
    }
    EXPECT_EQ(count, pieces);
    EXPECT_EQ(piece, right);
  }
}

TEST(LabelIslands, OnlyWholePiecesChangeSides) {
  std::int64_t islands = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Setting s(test::torus(200, seed));
    std::vector<char> inside = test::random_labels(s.mesh, seed, 4);
    const std::vector<char> before = inside;
    std::vector<Index> piece;
    label_pieces(s.mesh, inside, piece);
    const std::int64_t dropped = drop_islands(s.mesh, s.geometry, inside);
    std::set<Index> changed, kept;
    for (std::size_t t = 0; t < inside.size(); ++t)
      (inside[t] != before[t] ? changed : kept).insert(piece[t]);
    for (const Index p : changed) EXPECT_EQ(kept.count(p), 0u);
    EXPECT_LE(static_cast<std::int64_t>(changed.size()), dropped);
    EXPECT_EQ(dropped > 0, !changed.empty());
    for (std::size_t t = 0; t < inside.size(); ++t) EXPECT_FALSE(inside[t] && s.infinite(t));
    islands += dropped;
  }
  EXPECT_GT(islands, 0);
}

TEST(LabelIslands, AnIslandIsDroppedAndAPartIsKept) {
  std::vector<Point> points = test::ellipsoid(2000, 4, 0);
  for (const Point& p : test::ellipsoid(2000, 5, 3)) points.push_back(p);
  const Setting s(points);
  // Below 1 inside the ellipsoid at x0.
  const auto level = [&](std::size_t t, double x0) {
    const Point p = s.set.to_input(s.centre(t));
    return Vec3(p[0] - x0, p[1] / 0.8, p[2] / 0.6).norm();
  };
  std::vector<char> inside(s.mesh.size());
  Index island = kNone;
  for (std::size_t t = 0; t < inside.size(); ++t) {
    if (s.infinite(t)) continue;
    const double left = level(t, 0), right = level(t, 3);
    inside[t] = right < 0.99;  // all of the right one; of the left one a single tetrahedron
    if (left > 0.9 && left < 0.98) island = static_cast<Index>(t);
  }
  ASSERT_NE(island, kNone);
  inside[island] = 1;
  EXPECT_GE(drop_islands(s.mesh, s.geometry, inside), 1);
  EXPECT_FALSE(inside[island]);
  for (std::size_t t = 0; t < inside.size(); ++t)
    if (!s.infinite(t) && level(t, 3) < 0.9) {
      EXPECT_TRUE(inside[t]) << t;
    }
}

}  // namespace
}  // namespace filmsticking
