// SPDX-License-Identifier: GPL-3.0-or-later
// Files as such: what cannot be read or written, and replacement.
#include "io/files.h"

#include <gtest/gtest.h>

#include "samples.h"

namespace filmsticking::test {
namespace {

TEST(Files, WhatCannotBeReadIsSaid) {
  const ScratchFolder folder;
  write_text(folder / "empty.ply", "");
  write_text(folder / "none.xyz", "# no points\n");
  write_text(folder / "cloud.las", "LASF");
  write_text(folder / "noise.stl", "noise");
  EXPECT_NE(error_of(folder / "missing.ply"), "");
  EXPECT_NE(error_of(folder.path().string()), "");
  for (const char* name : {"empty.ply", "none.xyz", "cloud.las", "noise.stl"})
    EXPECT_NE(error_of(folder / name), "") << name;
}

TEST(Files, MoreBytesThanTheBoundAreNotRead) {
  const ScratchFolder folder;
  write_text(folder / "cloud.xyz", "0 0 0\n1 0 0\n");
  EXPECT_EQ(io::read_file(folder / "cloud.xyz", 12).size(), 12u);
  EXPECT_THROW(io::read_file(folder / "cloud.xyz", 11), IoError);
  EXPECT_THROW(io::read_cloud(folder / "cloud.xyz", {11}), IoError);
  // A file with a hole: no byte of it is on the disk.
  std::filesystem::resize_file(folder / "cloud.xyz", io::most_bytes_read() + 1);
  EXPECT_NE(error_of(folder / "cloud.xyz").find("larger"), std::string::npos);
}

TEST(Files, AFileIsReplacedWholeThroughALink) {
  const ScratchFolder folder;
  write_text(folder / "target.ply", "old");
  std::filesystem::create_symlink(folder / "target.ply", folder / "link.ply");
  io::write_file(folder / "link.ply", "new bytes");
  EXPECT_EQ(io::read_file(folder / "target.ply"), "new bytes");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.ply"));
  EXPECT_EQ(folder.count(), 2u);
}

TEST(Files, WhatEndsHalfwayLeavesWhatWasThere) {
  const ScratchFolder folder;
  const auto write_half = [&] {
    io::write_file(folder / "mesh.ply", [](const io::ByteSink& sink) {
      sink("half of it");
      throw IoError("enough");
    });
  };
  EXPECT_THROW(write_half(), IoError);
  EXPECT_EQ(folder.count(), 0u);
  write_text(folder / "mesh.ply", "old");
  EXPECT_THROW(write_half(), IoError);
  EXPECT_EQ(folder.count(), 1u);
  EXPECT_EQ(io::read_file(folder / "mesh.ply"), "old");
}

TEST(Files, WhatCannotBeWrittenIsRefused) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "folder.ply");
  EXPECT_THROW(io::write_file(folder / "folder.ply", "x"), IoError);
  EXPECT_THROW(io::write_file(folder / "no/such/folder.ply", "x"), IoError);
  EXPECT_THROW(io::write_file("/dev/null", "x"), IoError);
  EXPECT_THROW(io::write_file("/proc/mesh.ply", "x"), IoError);
  EXPECT_THROW(io::write_mesh(folder / "mesh.foo", tetrahedron(true)), IoError);
  EXPECT_EQ(folder.count(), 1u);
}

}  // namespace
}  // namespace filmsticking::test
