// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "io/cloud.h"
#include "poses.h"
#include "stream/frame_points.h"
#include "stream/frame_source.h"
#include "stream/pose_source.h"

namespace filmsticking::stream {
namespace {

const std::string kBun0 = TEST_DATA "/bun0.pcd", kBun4 = TEST_DATA "/bun4.pcd";

std::vector<Point> points_of(const Frame& frame) { return io::positions_of(frame_points(frame, {})); }

/// The transformation from bun0 to bun4 that the tests of PCL's own ICP expect.
Pose bun0_to_bun4() {
  Pose expected = Pose::Identity();
  expected.matrix() << 0.8806, 0.0365, -0.4724, 0.03453,  //
      -0.02354, 0.9992, 0.03326, -0.001519,               //
      0.4732, -0.01817, 0.8808, 0.04116,                  //
      0, 0, 0, 1;
  expected.linear() = Eigen::Quaterniond(expected.linear()).normalized().toRotationMatrix();
  return expected;
}

TEST(RegisteredPoses, FindsTheMotionBetweenTwoRealScans) {
  for (const Fit method : {Fit::Icp, Fit::Gicp}) {
    RegistrationOptions options;
    options.fit = method;
    const auto poses = registered_poses(options);
    const auto source = file_sequence({kBun0, kBun4});
    const Frame first = *source->next(), second = *source->next();
    EXPECT_TRUE(poses(first, points_of(first)).pose->isApprox(Pose::Identity()));
    const Placement found = poses(second, points_of(second));
    ASSERT_TRUE(found.pose) << found.reason;
    const auto [angle, shift] = difference(*found.pose, bun0_to_bun4().inverse());
    // Points are 0.004 apart, and the parts that do not overlap pull at PCL's fit, too.
    EXPECT_LT(angle, 0.15);   // of 0.49
    EXPECT_LT(shift, 0.012);  // of a scan of 0.15
  }
}

TEST(RegisteredPoses, IsTheSameInEveryUnitAndFarFromTheOrigin) {
  const auto fit = [](double scale, const Eigen::Vector3d& offset) {
    const auto poses = registered_poses({});
    const auto source = file_sequence({kBun0, kBun4});
    Placement found;
    for (int k = 0; k < 2; ++k) {
      const Frame frame = *source->next();
      std::vector<Point> points = points_of(frame);
      for (Point& p : points)
        for (int axis = 0; axis < 3; ++axis) p[axis] = scale * p[axis] + offset[axis];
      found = poses(frame, points);
    }
    return found;
  };
  const Placement once = fit(1, {0, 0, 0}), larger = fit(1000, {0, 0, 0});
  ASSERT_TRUE(once.pose && larger.pose);
  const auto [angle, shift] =
      difference(*once.pose, Pose(Eigen::Translation3d(larger.pose->translation() / 1000) *
                                  Eigen::Quaterniond(larger.pose->linear())));
  EXPECT_LT(angle, 0.01);
  EXPECT_LT(shift, 0.001);
  ASSERT_TRUE(fit(1, {5e5, 4e6, 100}).pose);
}

TEST(RegisteredPoses, AFrameThatDoesNotFitIsRefused) {
  const auto poses = registered_poses({});
  const auto source = file_sequence({kBun0, TEST_DATA "/lamppost.pcd"});
  const Frame bunny = *source->next(), lamppost = *source->next();
  ASSERT_TRUE(poses(bunny, points_of(bunny)).pose);
  const Placement none = poses(lamppost, points_of(lamppost));
  EXPECT_FALSE(none.pose);
  EXPECT_NE(none.reason.find("fit"), std::string::npos);
  EXPECT_FALSE(poses(lamppost, {{0, 0, 0}, {1, 1, 1}}).pose);
  EXPECT_FALSE(poses(lamppost, std::vector<Point>(100, Point{1, 1, 1})).pose);
  ASSERT_TRUE(poses(bunny, points_of(bunny)).pose);  // it goes on
}

}  // namespace
}  // namespace filmsticking::stream
