// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/self_intersections.h"

#include <gtest/gtest.h>

#include <vector>

#include "report/report.h"
#include "support/shapes.h"

namespace filmsticking::mesh_report {
namespace {

using test::box;
using test::joined;
using test::Model;
using test::triangles;

Report report(const Model& model) { return report_on(make_surface(model)); }

TEST(SelfIntersections, ByTheCornersThatFacesShare) {
  const Point a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  const auto pairs = [](const std::vector<Point>& p, const std::vector<Triangle>& t) {
    return self_intersections(make_surface(triangles(p, t))).pairs;
  };
  // None: one through the other, beside it, touching it.
  EXPECT_EQ(pairs({a, b, c, {.2, .2, -1}, {.2, .2, 1}, {-1, -1, 0}}, {{0, 1, 2}, {3, 4, 5}}), 1);
  EXPECT_EQ(pairs({a, b, c, {2, .2, -1}, {2, .2, 1}, {3, -1, 0}}, {{0, 1, 2}, {3, 4, 5}}), 0);
  EXPECT_EQ(pairs({a, b, c, {.2, .2, 0}, {.2, .2, 1}, {.3, .2, 1}}, {{0, 1, 2}, {3, 4, 5}}), 1);
  // One: apart from it, through the other's opposite side, lying on it.
  EXPECT_EQ(pairs({a, b, c, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}), 0);
  EXPECT_EQ(pairs({a, b, c, {.3, .3, 1}, {.3, .3, -1}}, {{0, 1, 2}, {0, 3, 4}}), 1);
  EXPECT_EQ(pairs({a, b, c, {.4, .2, 0}, {.2, .4, 0}}, {{0, 1, 2}, {0, 3, 4}}), 1);
  // Two: at an angle, side by side, folded onto it. Three: the same face.
  EXPECT_EQ(pairs({a, b, c, {0, -1, .1}}, {{0, 1, 2}, {1, 0, 3}}), 0);
  EXPECT_EQ(pairs({a, b, c, {0, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}), 0);
  EXPECT_EQ(pairs({a, b, c, {.1, .2, 0}}, {{0, 1, 2}, {1, 0, 3}}), 1);
  EXPECT_EQ(pairs({a, b, c}, {{0, 1, 2}, {0, 2, 1}}), 1);
  // A face without area meets nothing.
  EXPECT_EQ(pairs({a, b, c, {.2, .2, -1}, {.2, .2, 1}, {.2, .2, 0}}, {{0, 1, 2}, {3, 4, 5}}), 0);
}

TEST(SelfIntersections, OfBoxes) {
  EXPECT_EQ(report(box()).self_intersections, 0);
  EXPECT_EQ(report(joined(box(), box({2, 0, 0}, {3, 1, 1}))).self_intersections, 0);
  // A bar through two opposite sides of a box, off their diagonals: all 8 triangles of its mantle go through
  // one triangle of either side.
  const Report bar = report(joined(box({0, 0, 0}, {1, 1, 1}), box({.6, .2, -1}, {.8, .3, 2})));
  EXPECT_EQ(bar.self_intersections, 16);
  EXPECT_TRUE(bar.topology.closed && bar.topology.manifold);
}

}  // namespace
}  // namespace filmsticking::mesh_report
