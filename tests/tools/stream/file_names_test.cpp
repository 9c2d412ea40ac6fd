// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>

#include "stream/frame_source.h"
#include "stream/stream_error.h"
#include "support/scratch_folder.h"

namespace filmsticking::stream {
namespace {

using test::ScratchFolder;

TEST(FileNames, AreSortedByTheirNumbers) {
  const ScratchFolder folder;
  for (const char* name : {"scan_10.pcd", "scan_2.pcd", "scan_1.PCD", "notes.txt", "scan_002b.pcd"})
    std::ofstream(folder / name) << "x";
  const std::vector<std::string> expected = {folder / "scan_1.PCD", folder / "scan_2.pcd",
                                             folder / "scan_002b.pcd", folder / "scan_10.pcd"};
  EXPECT_EQ(frame_files_in(folder.path().string()), expected);
  EXPECT_THROW(frame_files_in(folder / "missing"), StreamError);
  const ScratchFolder empty;
  EXPECT_THROW(frame_files_in(empty.path().string()), StreamError);
}

TEST(FileNames, TellTheTime) {
  EXPECT_EQ(time_in_name("a/1305031102.175304.pcd"), 1305031102.175304);
  EXPECT_EQ(time_in_name("scan_007.pcd"), 7);
  EXPECT_EQ(time_in_name("v2.scan.5.pcd"), 5);
  EXPECT_FALSE(time_in_name("cloud.pcd"));
  EXPECT_FALSE(time_in_name("scan_1b.pcd"));
}

}  // namespace
}  // namespace filmsticking::stream
