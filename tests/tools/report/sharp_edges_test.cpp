// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sharp_edges.h"

#include <gtest/gtest.h>

#include <utility>

#include "report/report.h"
#include "support/shapes.h"

namespace filmsticking::mesh_report {
namespace {

using test::box;
using test::Model;
using test::sphere;

TEST(SharpEdges, AreEdgesOfTheMeshOrNot) {
  const Surface truth = make_surface(box());
  EXPECT_EQ(sharp_edges(truth, truth).edges, 12);  // not the diagonals
  EXPECT_EQ(sharp_edges(truth, truth).restored, 100);
  Model cut = box();  // the edge from 0 to 1 is one from 3 to 5
  cut.triangles[1] = {0, 3, 5};
  cut.triangles[4] = {3, 1, 5};
  EXPECT_EQ(sharp_edges(make_surface(cut), truth).edges, 12);
  EXPECT_DOUBLE_EQ(*sharp_edges(make_surface(cut), truth).restored, 100. * 11 / 12);
  // Of its 18 edges four are diagonals of flat squares, and all but one are the box's; all the same inside
  // out.
  for (Triangle& t : cut.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(sharp_edges(truth, make_surface(cut)).edges, 14);
  EXPECT_DOUBLE_EQ(*sharp_edges(truth, make_surface(cut)).restored, 100. * 13 / 14);
  Model moved = box();
  moved.positions[0] = {0.1, 0, 0};  // three edges lack an end
  EXPECT_EQ(sharp_edges(make_surface(moved), truth).edges, 9);
  EXPECT_FALSE(sharp_edges(make_surface(box({5, 5, 5}, {6, 6, 6})), truth).restored);
  EXPECT_EQ(sharp_edges(make_surface(sphere(1)), make_surface(sphere(1))).edges, 0);
}

}  // namespace
}  // namespace filmsticking::mesh_report
