// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/sight.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

Sight sight_of(const Setting& s, const std::vector<Vec3>& viewpoints) {
  return lines_of_sight(s.mesh, s.set.perturbed, s.geometry, s.evidence, viewpoints);
}

// Every site of a ball is seen from straight above it: no line passes through the ball.
std::vector<Vec3> from_above_each(const Setting& s, double distance) {
  std::vector<Vec3> viewpoints;
  for (const Vec3& site : s.set.perturbed) viewpoints.push_back(site * (1 + distance));
  return viewpoints;
}

TEST(Sight, IsNeverAgainstATruthThatItSees) {
  const Setting s(test::sphere(3000, 3));
  for (const double distance : {0.1, 1.0, 1e6}) {
    const Sight sight = sight_of(s, from_above_each(s, distance));
    EXPECT_EQ(sight.lines, 3000);
    EXPECT_EQ(sight.leaving, 3000);
    EXPECT_EQ(sight.blocked, 0);
    double behind = 0;
    for (std::size_t t = 0; t < s.mesh.size(); ++t) {
      if (s.infinite(t)) continue;
      EXPECT_GE(sight.votes[t], 0) << s.centre(t).norm();
      behind += sight.votes[t];
    }
    EXPECT_NEAR(behind, 3000, 300);  // one line each, less what the rounding of walks hides
  }
}

TEST(Sight, FromTheMiddleOfAShellItsSpaceIsSeen) {
  const Setting s(test::sphere(3000, 4));
  const Sight sight = sight_of(s, std::vector<Vec3>(3000, Vec3::Zero()));
  EXPECT_EQ(sight.leaving, 0);
  EXPECT_EQ(sight.blocked, 0);
  for (std::size_t t = 0; t < s.mesh.size(); ++t)
    if (!s.infinite(t) && s.centre(t).norm() < 0.3) {
      EXPECT_LE(sight.votes[t], 0);
    }
}

TEST(Sight, AWrongSensorIsContradictedByManyLines) {
  const Setting s(test::sphere(3000, 5));
  for (const Vec3& wrong : {Vec3(2, 0, 0), Vec3(50, 70, -90)}) {
    const Sight sight = sight_of(s, std::vector<Vec3>(3000, wrong));
    EXPECT_GT(sight.blocked, 3000 / 4);
    EXPECT_LT(sight.blocked, 3000);
  }
}

TEST(Sight, UnknownSensorsSayNothing) {
  const Setting s(test::sphere(500, 6));
  std::vector<Vec3> viewpoints(500, Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  viewpoints[1] = Vec3::Constant(std::numeric_limits<double>::infinity());
  viewpoints[2] = s.set.perturbed[2];  // in the site itself
  const Sight sight = sight_of(s, viewpoints);
  EXPECT_EQ(sight.lines, 0);
  for (const float vote : sight.votes) EXPECT_EQ(vote, 0);
}

TEST(Sight, TheVotesDoNotDependOnThreads) {
  const Setting s(test::torus(4000, 7));
  const std::vector<Vec3> viewpoints(4000, Vec3(0.3, 0.2, 5));
  const Sight many = sight_of(s, viewpoints);
  tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(sight_of(s, viewpoints).votes, many.votes);
}

TEST(Sight, ACancelledWalkThrows) {
  const Setting s(test::sphere(500, 1));
  const std::atomic<bool> wish{true};
  EXPECT_THROW(
      lines_of_sight(s.mesh, s.set.perturbed, s.geometry, s.evidence, from_above_each(s, 1), {&wish}),
      Cancelled);
}

// On a grid every line meets vertices and edges of tetrahedra.
TEST(Sight, LinesAlongAGridEnd) {
  const Setting s(test::grid(10));
  for (const Vec3& sensor : {Vec3(0, 0, 3), Vec3(3, 3, 3), Vec3(0, 0, 0)})
    EXPECT_GT(sight_of(s, std::vector<Vec3>(s.set.size(), sensor)).lines, 0);
}

}  // namespace
}  // namespace filmsticking
