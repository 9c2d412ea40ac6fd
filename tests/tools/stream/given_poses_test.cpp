// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "poses.h"
#include "stream/pose_source.h"

namespace filmsticking::stream {
namespace {

TEST(Poses, OfATrajectoryGoByTimeOrByNumber) {
  Trajectory given;
  for (int k = 0; k < 3; ++k) given.add(k, pose(k, 0, 0, 0, {1, 0, 0}));
  const auto poses = trajectory_poses(given);
  Frame frame;
  for (int k = 0; k < 3; ++k) EXPECT_EQ(poses(frame, {}).pose->translation().x(), k);
  EXPECT_FALSE(poses(frame, {}).pose);
  frame.time = 1;
  EXPECT_EQ(poses(frame, {}).pose->translation().x(), 1);
  frame.time = 7;
  const Placement none = poses(frame, {});
  EXPECT_FALSE(none.pose);
  EXPECT_NE(none.reason, "");
}

TEST(Poses, OfTheCloudsGoBeforeAFit) {
  const auto poses = sensor_poses_or(trajectory_poses(parse_trajectory("0 9 0 0 0 0 0 1\n")));
  Frame frame;
  EXPECT_EQ(poses(frame, {}).pose->translation().x(), 9);
  frame.sensor_pose = pose(1, 2, 3, 1, {0, 1, 0});
  EXPECT_TRUE(poses(frame, {}).pose->isApprox(frame.sensor_pose));
}

TEST(Poses, ACloudsIdentityDoesNotSayWhereTheSensorWas) {
  const auto poses = sensor_poses();
  Frame frame;
  EXPECT_TRUE(poses(frame, {}).pose);
  EXPECT_FALSE(poses(frame, {}).sensor_known);
  frame.sensor_pose = pose(1, 2, 3, 1, {0, 1, 0});
  EXPECT_TRUE(poses(frame, {}).sensor_known);
}

}  // namespace
}  // namespace filmsticking::stream
