// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/meeting_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/meeting.h"
#include "support/clouds.h"
#include "support/surfaces.h"

namespace filmsticking {
namespace {

std::int64_t meeting_faces(Surface& surface) {
  SiteGeometry geometry;
  geometry.spacing.assign(surface.positions.size(), 0.1);
  return remove_meeting_faces(surface, geometry);
}

bool some_meet(const Surface& surface) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t u = 0; u < t; ++u)
      if (!Meeting(surface.positions, surface.triangles[t], surface.triangles[u], kMeetingMargin)
               .in_common_corners_only())
        return true;
  return false;
}

// A square grid in a plane, of which some inner vertices are moved two cells on: their faces fold over.
Surface folded_sheet(std::uint64_t seed, int folds) {
  constexpr int n = 12;
  std::vector<Vec3> positions;
  std::vector<Corners> triangles;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) positions.emplace_back(i / 16.0, j / 16.0, 0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Index a = i * (n + 1) + j, b = a + n + 1;
      triangles.push_back({a, b, b + 1}), triangles.push_back({a, b + 1, a + 1});
    }
  test::Random random(seed);
  for (int k = 0; k < folds; ++k) {
    const int i = static_cast<int>(random.uniform(2, n - 2)), j = static_cast<int>(random.uniform(2, n - 2));
    positions[i * (n + 1) + j] += Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0) / 8;
  }
  return test::surface_of(std::move(positions), std::move(triangles));
}

// Rows of pixels that lie in a plane exactly came with faces folded over onto others.
TEST(MeetingFaces, Regression_FoldsInExactPlanesAreTakenAway) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Surface sheet = folded_sheet(seed, 3);
    Surface surface = sheet;
    ASSERT_EQ(meeting_faces(surface) > 0, some_meet(sheet)) << seed;
    EXPECT_FALSE(some_meet(surface)) << seed;
    EXPECT_TRUE(check_manifold(surface.triangles, static_cast<Index>(surface.positions.size())).manifold())
        << seed;
    EXPECT_GE(surface.triangles.size() + 3 * 12, sheet.triangles.size()) << seed;
    EXPECT_EQ(meeting_faces(surface), 0) << seed;
  }
}

TEST(MeetingFaces, NoNumberingChangesWhatStays) {
  const auto sites = [](const Surface& surface) {
    std::vector<std::array<Index, 3>> all;
    for (const Corners& t : surface.triangles) {
      all.push_back({surface.site[t[0]], surface.site[t[1]], surface.site[t[2]]});
      std::sort(all.back().begin(), all.back().end());
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Surface surface = folded_sheet(seed, 3), other = surface;
    std::reverse(other.triangles.begin(), other.triangles.end());
    for (Corners& t : other.triangles) std::rotate(t.begin(), t.begin() + 1, t.end());
    meeting_faces(surface), meeting_faces(other);
    EXPECT_EQ(sites(surface), sites(other)) << seed;
  }
}

// All pairs of a large surface would not fit into memory.
TEST(MeetingFaces, VeryManyThatMeetAllOthersGo) {
  std::vector<Vec3> positions;
  std::vector<Corners> triangles;
  test::Random random(1);
  for (Index t = 0; t < 5000; ++t) {
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * std::acos(-1) * (k + random.uniform(0, 0.3)) / 3;
      positions.emplace_back(std::cos(angle) / 2, std::sin(angle) / 2, 0);
    }
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  Surface surface = test::surface_of(std::move(positions), std::move(triangles));
  EXPECT_EQ(meeting_faces(surface), 5000);
  EXPECT_TRUE(surface.triangles.empty());
}

TEST(MeetingFaces, ThoseThatMeetNoOtherStay) {
  Surface surface = test::ball_without([](const Vec3& p) { return p.z() > 0.5; });
  const std::vector<Corners> before = surface.triangles;
  EXPECT_EQ(meeting_faces(surface), 0);
  EXPECT_EQ(surface.triangles, before);
}

}  // namespace
}  // namespace filmsticking
