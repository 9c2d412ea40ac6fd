// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/lids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

std::vector<Opening> closed_up_to(double most, Surface& surface) {
  const auto vertices = static_cast<Index>(surface.positions.size());
  std::vector<Opening> openings = close_rims(surface, test::twins_of(surface), most);
  const ManifoldCheck check = check_manifold(surface.triangles, vertices);
  EXPECT_TRUE(check.manifold());
  const bool all = std::all_of(openings.begin(), openings.end(), [](const Opening& o) { return o.closed; });
  EXPECT_EQ(check.closed, all);
  return openings;
}

int lids(const std::vector<Opening>& openings) {
  return static_cast<int>(
      std::count_if(openings.begin(), openings.end(), [](const Opening& o) { return o.closed; }));
}

// A ball of diameter 1 with round holes of these diameters, far from each other.
Surface with_holes(double first, double second) {
  const Surface whole = test::ball();
  const double r = whole.positions[0].norm();
  const Vec3 a(0, 0, r), b(0, r, 0);
  return test::ball_without(
      [&](const Vec3& p) { return (p - a).norm() < first * r || (p - b).norm() < second * r; });
}

TEST(Lids, CloseTheHolesUpToADiameterAndNoOthers) {
  const Surface open = with_holes(0.3, 0.7);
  Surface copy = open;
  std::vector<double> diameters;
  for (const Opening& o : close_rims(copy, test::twins_of(open), 0)) {
    EXPECT_FALSE(o.closed);
    std::vector<Vec3> corners;
    for (const Index v : o.rim) corners.push_back(open.positions[v]);
    diameters.push_back(measure_rim(corners).diameter);
  }
  ASSERT_EQ(diameters.size(), 2U);
  std::sort(diameters.begin(), diameters.end());
  for (int count = 0; count <= 2; ++count) {
    Surface surface = open;
    const double most = count == 0   ? 0.99 * diameters[0]
                        : count == 1 ? 0.99 * diameters[1]
                                     : 1.01 * diameters[1];
    EXPECT_EQ(lids(closed_up_to(most, surface)), count);
  }
}

TEST(Lids, AreAboutFlat) {
  Surface surface = with_holes(0.7, 0.0);
  const double open_area = test::area(surface);
  ASSERT_EQ(lids(closed_up_to(10, surface)), 1);
  const double r = surface.positions[0].norm(), rim = 0.7 * std::sqrt(1 - 0.7 * 0.7 / 4) * r;
  EXPECT_NEAR(test::area(surface) - open_area, M_PI * rim * rim, 0.15 * M_PI * rim * rim);
  EXPECT_GT(test::signed_volume6(surface), 0);
}

TEST(Lids, NoneOnAFlatSheetAndNoneOnASingleFace) {
  Surface sheet = test::square_sheet(5, 0.5);
  EXPECT_EQ(lids(closed_up_to(10, sheet)), 0);
  Surface face = test::surface_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  EXPECT_EQ(lids(closed_up_to(10, face)), 0);
}

// The least area goes through the wall.
TEST(Lids, AvoidAWallWhereTheyCan) {
  Surface surface = with_holes(0.7, 0.0);
  const double r = surface.positions[0].norm();
  const auto first = static_cast<Index>(surface.positions.size());
  for (const Vec3& p : {Vec3(0.03 * r, 0, 0.7 * r), Vec3(-0.03 * r, 0.02 * r, 0.7 * r), Vec3(0, 0, 0.8 * r)})
    surface.positions.push_back(p), surface.site.push_back(surface.site.back() + 1);
  surface.triangles.push_back({first, first + 1, first + 2});
  const std::size_t before = surface.triangles.size();
  Surface closed = surface;
  EXPECT_EQ(lids(closed_up_to(10, closed)), 1);
  closed.triangles.erase(closed.triangles.begin(),
                         closed.triangles.begin() + static_cast<std::ptrdiff_t>(before));
  EXPECT_FALSE(closed.triangles.empty());
}

// A ring of n corners with a tip below: a cone without its base.
TEST(Lids, CloseLongRimsSoon) {
  for (const int n : {250, 1500, 20000}) {
    std::vector<Vec3> positions{{0, 0, -0.5}};
    std::vector<Corners> triangles;
    for (int i = 0; i < n; ++i) {
      positions.emplace_back(0.5 * std::cos(2 * M_PI * i / n), 0.5 * std::sin(2 * M_PI * i / n), 0);
      triangles.push_back({0, 1 + (i + 1) % n, 1 + i});
    }
    Surface cone = test::surface_of(positions, triangles);
    EXPECT_EQ(lids(closed_up_to(2, cone)), 1);
    EXPECT_EQ(cone.triangles.size(), static_cast<std::size_t>(2 * n - 2));
  }
}

TEST(Lids, StopWhenAsked) {
  Surface surface = with_holes(0.3, 0.7);
  const std::atomic<bool> stop{true};
  EXPECT_THROW(close_rims(surface, test::twins_of(surface), 10, {&stop}), Cancelled);
}

}  // namespace
}  // namespace filmsticking
