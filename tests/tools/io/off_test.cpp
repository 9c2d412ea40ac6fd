// SPDX-License-Identifier: GPL-3.0-or-later
// OFF.
#include <gtest/gtest.h>

#include "samples.h"

namespace filmsticking::test {
namespace {

TEST(Off, KeepsNormalsAndColours) {
  const io::Cloud cloud =
      io::decode_cloud("off", "CNOFF\n2 0 0\n1 2 3 0 0 1 10 20 30\n4 5 6 0 1 0 40 50 60\n");
  EXPECT_EQ(io::positions_of(cloud.points), (std::vector<Point>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(normals_in(cloud.points), (std::vector<std::array<float, 3>>{{0, 0, 1}, {0, 1, 0}}));
  EXPECT_EQ(io::colours_of(cloud.points), (std::vector<Colour>{{10, 20, 30}, {40, 50, 60}}));
  EXPECT_TRUE(cloud.notes.empty());
}

TEST(Off, SaysWhatItLeavesOut) {
  EXPECT_EQ(io::decode_cloud("off", "STOFF\n1 0 0\n1 2 3 0.5 0.5\n").notes.size(), 1u);
  EXPECT_EQ(io::decode_cloud("off", "OFF\n1 0 0\n1 2 3 0 0 1 7 8 9\n").notes.size(), 1u);
  EXPECT_EQ(io::decode_cloud("off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n").notes.size(), 1u);
}

TEST(Off, AVertexWithOtherNumbersThanTheFirstIsRefused) {
  EXPECT_THROW(io::decode_cloud("off", "OFF\n2 0 0\n1 2 3\n1 2 3 9 9 9\n"), IoError);
  EXPECT_THROW(io::decode_cloud("off", "COFF\n2 0 0\n1 2 3 9 9 9\n1 2 3\n"), IoError);
}

}  // namespace
}  // namespace filmsticking::test
