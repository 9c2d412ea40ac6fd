// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/least_triangulation.h"

#include <gtest/gtest.h>

namespace filmsticking {
namespace {

const auto kAny = [](std::size_t, std::size_t) { return true; };
const auto kIgnore = [] {};

// Of faces of a polygon whose corners cost what lies between them.
double span(std::size_t i, std::size_t, std::size_t k) { return static_cast<double>(k - i); }

TEST(LeastTriangulation, HasTheFacesOfThePolygonInItsDirection) {
  const std::vector<Corners> faces = least_triangulation({10, 11, 12, 13, 14}, kAny, span, kIgnore);
  ASSERT_EQ(faces.size(), 3U);
  for (const Corners& t : faces) EXPECT_TRUE(t[0] < t[1] && t[1] < t[2]);
}

TEST(LeastTriangulation, CostsLeast) {
  // The chord from 1 to 3 is cheap: the faces beside it win.
  const auto cost = [](std::size_t i, std::size_t j, std::size_t k) {
    return (i == 1 && j == 2 && k == 3) || (i == 0 && j == 1 && k == 3) ? 1.0 : 5.0;
  };
  EXPECT_EQ(least_triangulation({0, 1, 2, 3}, kAny, cost, kIgnore),
            (std::vector<Corners>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(LeastTriangulation, KeepsOffForbiddenChordsAndFaces) {
  const auto no_13 = [](std::size_t i, std::size_t k) { return !(i == 1 && k == 3); };
  EXPECT_EQ(least_triangulation({0, 1, 2, 3}, no_13, span, kIgnore),
            (std::vector<Corners>{{0, 2, 3}, {0, 1, 2}}));
  const auto none = [](std::size_t, std::size_t) { return false; };
  EXPECT_TRUE(least_triangulation({0, 1, 2, 3}, none, span, kIgnore).empty());
  EXPECT_TRUE(least_triangulation({0, 1}, kAny, span, kIgnore).empty());
  EXPECT_THROW(least_triangulation({0, 1, 2}, kAny, span, [] { throw 1; }), int);
}

}  // namespace
}  // namespace filmsticking
