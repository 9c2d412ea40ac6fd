// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/cap_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

std::int64_t caps_removed(Surface& surface) {
  const auto vertices = static_cast<Index>(surface.positions.size());
  const std::int64_t removed = remove_cap_faces(surface, half_edge_twins(surface.triangles, vertices));
  EXPECT_TRUE(check_manifold(surface.triangles, vertices).manifold());
  std::vector<char> on(surface.positions.size(), 0);
  for (const Corners& t : surface.triangles)
    for (Index v : t) on[v] = 1;
  EXPECT_EQ(std::count(on.begin(), on.end(), 0), 0);
  return removed;
}

// 2 on the edge of 0 and 1; 3 above it, 4 below.
const std::vector<Vec3> kOnAnEdge = {{0, 0, 0}, {0.2, 0, 0}, {0.1, 1e-9, 0}, {0.1, 0.1, 0}, {0.1, -0.1, 0}};

TEST(CapFaces, AreFlippedIntoTheFaceAcross) {
  Surface surface = test::surface_of(kOnAnEdge, {{0, 1, 3}, {1, 0, 2}, {0, 4, 2}, {4, 1, 2}});
  const double before = test::area(surface);
  EXPECT_EQ(caps_removed(surface), 1);
  EXPECT_EQ(surface.triangles.size(), 4u);
  EXPECT_NEAR(test::area(surface), before, 1e-8);
  EXPECT_EQ(caps_removed(surface), 0);
}

TEST(CapFaces, AreLeftOutAtTheBorder) {
  // 2 is inside: its faces form a ring.
  Surface surface = test::surface_of({{0, 0, 0}, {0.2, 0, 0}, {0.1, 1e-9, 0}, {0.1, -0.1, 0}},
                                     {{1, 0, 2}, {0, 3, 2}, {3, 1, 2}});
  EXPECT_EQ(caps_removed(surface), 1);
  EXPECT_EQ(surface.triangles.size(), 2u);
}

TEST(CapFaces, StayWhereTheBorderWouldMeetItself) {
  Surface surface = test::surface_of({{0, 0, 0}, {0.2, 0, 0}, {0.1, 0, 0}, {0, -0.1, 0}, {0.2, -0.1, 0}},
                                     {{1, 0, 2}, {0, 3, 2}, {4, 1, 2}});
  const std::vector<Corners> before = surface.triangles;
  EXPECT_EQ(caps_removed(surface), 0);
  EXPECT_EQ(surface.triangles, before);
}

// An edge that was flipped and flipped back left its faces turned on, and their twins were those of others.
TEST(CapFaces, Regression_ThoseThatStayChangeNothing) {
  Surface surface =
      test::surface_of({{0, 0, 0}, {0.3, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}, {0.1, 0.1, 0}, {0.1, -0.1, 0}},
                       {{0, 1, 3}, {1, 0, 2}, {0, 5, 2}, {2, 5, 1}, {0, 3, 4}, {3, 1, 4}});
  const std::vector<Corners> before = surface.triangles;
  EXPECT_EQ(caps_removed(surface), 0);
  EXPECT_EQ(surface.triangles, before);
}

TEST(CapFaces, GoWhereSeveralLieOnOneEdge) {
  Surface surface =
      test::surface_of({{0, 0, 0}, {0.3, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}, {0.1, 0.1, 0}, {0.1, -0.1, 0}},
                       {{0, 1, 4}, {1, 0, 3}, {3, 0, 2}, {0, 5, 2}, {2, 5, 3}, {3, 5, 1}});
  const double before = test::area(surface);
  EXPECT_EQ(caps_removed(surface), 2);
  EXPECT_NEAR(test::area(surface), before, 1e-12);
  EXPECT_EQ(caps_removed(surface), 0);
}

}  // namespace
}  // namespace filmsticking
