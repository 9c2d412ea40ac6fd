// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream/trajectory.h"

#include <gtest/gtest.h>

#include "poses.h"
#include "stream/stream_error.h"

namespace filmsticking::stream {
namespace {

TEST(Trajectory, IsReadAndInterpolated) {
  const Trajectory poses = parse_trajectory(
      "# a comment\n1 0 0 0 0 0 0 1\n\n1.1 1 2 3 0 0 0.70710678 0.70710678\n9 5 5 5 1 0 0 0\n");
  ASSERT_EQ(poses.size(), 3u);
  EXPECT_TRUE(poses.at(1)->isApprox(Pose::Identity(), 1e-7));
  EXPECT_TRUE(poses.at(1.1)->isApprox(pose(1, 2, 3, M_PI / 2, {0, 0, 1}), 1e-7));
  EXPECT_TRUE(poses.at(1.05)->isApprox(pose(0.5, 1, 1.5, M_PI / 4, {0, 0, 1}), 1e-7));
  EXPECT_TRUE(poses.at(9)->isApprox(pose(5, 5, 5, M_PI, {1, 0, 0}), 1e-7));
  EXPECT_FALSE(poses.at(0.9));
  EXPECT_FALSE(poses.at(5));  // too far from both
  EXPECT_FALSE(poses.at(9.1));
}

TEST(Trajectory, WhatIsWrittenReadsBack) {
  const Pose wanted = pose(-1.5, 2e3, 0.001, 2.5, {1, -2, 3});
  const auto read = parse_trajectory(trajectory_line(12.25, wanted)).at(12.25);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->isApprox(wanted, 1e-7));
}

TEST(Trajectory, NonsenseIsRefused) {
  for (const char* text : {"", "# nothing\n", "1 2 3\n", "1 0 0 0 0 0 0 2\n", "1 0 0 0 0 0 0 0\n",
                           "1 nan 0 0 0 0 0 1\n", "hello\n", "2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n"})
    EXPECT_THROW(parse_trajectory(text), StreamError) << text;
}

}  // namespace
}  // namespace filmsticking::stream
