// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>

#include "io/cloud.h"
#include "poses.h"
#include "stream/frame_source.h"
#include "stream/stream_error.h"
#include "support/scratch_folder.h"
#include "turntable.h"

namespace filmsticking::stream {
namespace {

const std::string kBun0 = TEST_DATA "/bun0.pcd";

TEST(PcdSequence, PlaysFilesAndContinuesAfterBrokenOnes) {
  const test::ScratchFolder folder;
  std::ofstream(folder / "broken_1.pcd") << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                                            "WIDTH 1000000000\nHEIGHT 1\nPOINTS 1000000000\nDATA binary\n12";
  const Pose viewpoint = pose(1, -2, 3, 1.2, {1, 1, 0});
  test::write_pcd(folder / "scan_2.5.pcd", {{1, 2, 3}, {4, 5, 6}}, &viewpoint);
  const auto source = pcd_sequence({kBun0, folder / "broken_1.pcd", folder / "scan_2.5.pcd"});
  EXPECT_EQ(source->size(), 3u);
  const auto bunny = source->next();
  ASSERT_TRUE(bunny);
  EXPECT_EQ(bunny->name, "bun0.pcd");
  EXPECT_EQ(bunny->time, 0);
  EXPECT_EQ(bunny->cloud.width, 397u);
  EXPECT_TRUE(bunny->sensor_pose.isApprox(Pose::Identity()));
  EXPECT_THROW(source->next(), StreamError);
  const auto scan = source->next();
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->time, 2.5);
  EXPECT_TRUE(scan->sensor_pose.isApprox(viewpoint, 1e-6));
  EXPECT_EQ(io::positions_of(scan->cloud), (std::vector<Point>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_TRUE(source->at_end());
  EXPECT_FALSE(source->next());
}

}  // namespace
}  // namespace filmsticking::stream
