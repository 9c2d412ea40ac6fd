// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pinholes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

std::int64_t holes_filled(Surface& surface, double spacing) {
  const auto vertices = static_cast<Index>(surface.positions.size());
  SiteGeometry geometry;
  geometry.spacing.assign(surface.positions.size(), spacing);
  const std::int64_t filled = fill_pinholes(surface, half_edge_twins(surface.triangles, vertices), geometry);
  EXPECT_TRUE(check_manifold(surface.triangles, vertices).manifold());
  return filled;
}

std::int64_t border_edges(const Surface& surface) {
  return check_manifold(surface.triangles, static_cast<Index>(surface.positions.size())).boundary_edges;
}

TEST(Pinholes, AreFilledIfTheyAreNotWide) {
  const Surface whole = test::ball_without([](const Vec3&) { return false; });
  const double spacing = std::sqrt(test::area(whole) / static_cast<double>(whole.positions.size()));
  const Vec3 a = whole.corner(7, 0),
             b = (whole.corner(40, 0) + whole.corner(40, 1) + whole.corner(40, 2)) / 3;
  const auto near = [&](const Vec3& p) {
    return (p - a).norm() < 0.9 * spacing || (p - b).norm() < 0.1 * spacing;  // a ring of faces, and one face
  };
  Surface surface = test::ball_without(near);
  const std::int64_t edges = border_edges(surface);
  ASSERT_GE(edges, 7);
  EXPECT_EQ(holes_filled(surface, spacing / 5), 0);  // the same hole is five times as many spacings wide
  EXPECT_EQ(border_edges(surface), edges);
  EXPECT_EQ(holes_filled(surface, spacing), 2);
  EXPECT_EQ(border_edges(surface), 0);
  EXPECT_NEAR(test::area(surface), test::area(whole), 0.01 * test::area(whole));
}

TEST(Pinholes, TheRimOfAPieceIsNone) {
  const Surface whole = test::ball_without([](const Vec3&) { return false; });
  const double spacing = std::sqrt(test::area(whole) / static_cast<double>(whole.positions.size()));
  const Vec3 a = whole.corner(7, 0);
  Surface surface = test::ball_without([&](const Vec3& p) { return (p - a).norm() > 0.9 * spacing; });
  const std::int64_t edges = border_edges(surface);
  ASSERT_GE(edges, 5);
  EXPECT_EQ(holes_filled(surface, spacing), 0);
  EXPECT_EQ(border_edges(surface), edges);
}

// A wall through the hole.
TEST(Pinholes, StayWhereTheFillingWouldMeetAnother) {
  const Surface whole = test::ball_without([](const Vec3&) { return false; });
  const double spacing = std::sqrt(test::area(whole) / static_cast<double>(whole.positions.size()));
  const Vec3 a = whole.corner(7, 0);
  Surface surface = test::ball_without([&](const Vec3& p) { return (p - a).norm() < 0.9 * spacing; });
  const auto n = static_cast<Index>(surface.positions.size());
  const Vec3 across = spacing / 20 * a.unitOrthogonal();
  for (const Vec3& p : {Vec3(0.5 * a), Vec3(2 * a + across), Vec3(2 * a - across)})
    surface.positions.push_back(p), surface.site.push_back(static_cast<Index>(surface.site.size()));
  surface.triangles.push_back({n, n + 1, n + 2});
  EXPECT_EQ(holes_filled(surface, spacing), 0);
}

}  // namespace
}  // namespace filmsticking
