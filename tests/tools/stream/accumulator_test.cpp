// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream/accumulator.h"

#include <gtest/gtest.h>

#include "stream/frame_source.h"

namespace filmsticking::stream {
namespace {

const std::string kBun0 = TEST_DATA "/bun0.pcd", kBun4 = TEST_DATA "/bun4.pcd";

TEST(Accumulator, LeavesOutFramesAndSaysWhy) {
  Accumulator accumulator({}, trajectory_poses(parse_trajectory("0 0 0 0 0 0 0 1\n")));
  EXPECT_EQ(io::size_of(accumulator.cloud()), 0u);
  const auto source = file_sequence({kBun0, kBun4});
  const Frame bun0 = *source->next(), bun4 = *source->next();
  EXPECT_FALSE(accumulator.add(bun0));
  const auto fault = accumulator.add(bun4);  // its time is 4
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->find("trajectory"), std::string::npos);
  Frame without_fields = bun0;
  without_fields.cloud.fields.clear();
  EXPECT_TRUE(accumulator.add(without_fields));
  EXPECT_EQ(accumulator.placed().size(), 1u);
  EXPECT_EQ(accumulator.left_out(), 2u);
  EXPECT_GT(accumulator.size(), 100u);
}

TEST(Accumulator, SaysWhereEachPointWasSeenFrom) {
  Frame frame = *file_sequence({kBun0})->next();
  Accumulator unknown({}, sensor_poses()), known({}, sensor_poses());
  EXPECT_FALSE(unknown.add(frame));
  EXPECT_TRUE(io::viewpoints_of(unknown.cloud()).empty());
  frame.sensor_pose.translation() << 1, 2, 3;
  EXPECT_FALSE(known.add(frame));
  EXPECT_EQ(io::viewpoints_of(known.cloud()), std::vector<Point>(known.size(), {1, 2, 3}));
}

}  // namespace
}  // namespace filmsticking::stream
