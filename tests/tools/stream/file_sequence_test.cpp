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

TEST(FileSequence, PlaysFilesAndContinuesAfterBrokenOnes) {
  const test::ScratchFolder folder;
  std::ofstream(folder / "broken_1.pcd") << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                                            "WIDTH 1000000000\nHEIGHT 1\nPOINTS 1000000000\nDATA binary\n12";
  const Pose viewpoint = pose(1, -2, 3, 1.2, {1, 1, 0});
  test::write_pcd(folder / "scan_2.5.pcd", {{1, 2, 3}, {4, 5, 6}}, &viewpoint);
  const auto source = file_sequence({kBun0, folder / "broken_1.pcd", folder / "scan_2.5.pcd"});
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

TEST(FileSequence, FramesMayBeFilesOfAnyFormat) {
  const test::ScratchFolder folder;
  std::ofstream(folder / "a_1.xyz") << "1 2 3\n4 5 6\n";
  std::ofstream(folder / "b_2.ply") << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                                       "property float y\nproperty float z\nend_header\n7 8 9\n";
  // Two stations; the second is turned by a quarter around z, at (10, 20, 30).
  std::ofstream(folder / "c.ptx") << "1\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"
                                     "1 2 3 0.5\n1\n1\n10 20 30\n0 1 0\n-1 0 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n"
                                     "0 0 1 0\n10 20 30 1\n1 2 3 0.5\n";
  const auto files = frame_files_in(folder.path().string());
  ASSERT_EQ(files.size(), 3u);
  const auto source = file_sequence(files);
  EXPECT_FALSE(source->size());
  std::vector<Frame> frames;
  while (auto frame = source->next()) frames.push_back(*frame);
  ASSERT_EQ(frames.size(), 4u);
  EXPECT_EQ(frames[0].time, 1);
  EXPECT_EQ(io::positions_of(frames[0].cloud), (std::vector<Point>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(io::positions_of(frames[1].cloud), (std::vector<Point>{{7, 8, 9}}));
  EXPECT_EQ(frames[3].name, "c.ptx, station 2");
  EXPECT_EQ(io::positions_of(frames[3].cloud), (std::vector<Point>{{1, 2, 3}}));
  EXPECT_TRUE((frames[3].sensor_pose * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector3d(8, 21, 33)));
}

TEST(FileSequence, PcdFramesAreReadAsAllPcdFiles) {
  const test::ScratchFolder folder;
  std::ofstream(folder / "a.pcd")
      << "FIELDS X Y Z r g b\nCOUNT 1 1 1 1 1 1\nSIZE 8 4 4 1 1 1\nTYPE F F F U U U\nHEIGHT 1\n"
         "WIDTH 1\nVIEWPOINT 1 2 3 0 0 0 1\nDATA ascii\n4 5 6 10 20 30\n";
  const auto frame = file_sequence({folder / "a.pcd"})->next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(io::positions_of(frame->cloud), (std::vector<Point>{{4, 5, 6}}));
  EXPECT_EQ(io::colours_of(frame->cloud), (std::vector<io::Colour>{{10, 20, 30}}));
  EXPECT_TRUE((frame->sensor_pose * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(0, 2, 3)));
}

TEST(FileSequence, AFrameSaysHowItWasRead) {
  const test::ScratchFolder folder;
  std::ofstream(folder / "a.xyz") << "1 2 3 0.5\n4 5 6 0.7\n";
  EXPECT_EQ(file_sequence({folder / "a.xyz"})->next()->notes.size(), 1u);
}

}  // namespace
}  // namespace filmsticking::stream
