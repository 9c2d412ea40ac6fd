// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of points as text.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "io/files.h"
#include "samples.h"

namespace filmsticking::test {
namespace {

TEST(Files, WrittenTextHasPositionsAndNormals) {
  const ScratchFolder folder;
  const io::Cloud cloud = labelled(false);
  io::write_cloud(folder / "a.xyz", cloud);
  EXPECT_TRUE(
      same_bits(io::positions_of(io::read_cloud(folder / "a.xyz").points), io::positions_of(cloud.points)));
  std::istringstream text(io::read_file(folder / "a.xyz"));
  double x = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 6; ++k) {
      ASSERT_TRUE(text >> x);
      if (k < 3) continue;
      EXPECT_EQ(static_cast<float>(x), normals_in(cloud.points)[i][k - 3]);
    }
  EXPECT_THROW(io::write_cloud(folder / "a.obj", cloud), IoError);
}

TEST(Xyz, SeparatorsCommentsAndHeadingsAreUnderstood) {
  for (const char* separator : {" ", ",", ";", "\t", ", ", "  "}) {
    std::string text = "4\na heading\n# comment\n// another\n\n0.1 0.2 0.3\n1 2 3\r\n\nnan NaN inf\n7 8 9";
    for (std::size_t at = text.find("0.1"); (at = text.find(' ', at)) != std::string::npos;
         at += std::string_view(separator).size())
      text.replace(at, 1, separator);
    const Model model = io::decode_xyz(text);
    ASSERT_EQ(model.positions.size(), 4u) << text;
    EXPECT_EQ(model.positions[0], (Point{0.1, 0.2, 0.3}));
    EXPECT_EQ(model.positions[1], (Point{1, 2, 3}));
    EXPECT_TRUE(std::isnan(model.positions[2][0]));
    EXPECT_EQ(model.positions[3], (Point{7, 8, 9}));
  }
}

TEST(Xyz, WholeNumbersUpTo255AreColours) {
  EXPECT_EQ(Model(io::decode_xyz("0 0 0 255 128 0\n1 0 0 1 2 3\n")).colours,
            (std::vector<Colour>{{255, 128, 0}, {1, 2, 3}}));
  EXPECT_TRUE(Model(io::decode_xyz("0 0 0 0 0 1\n1 0 0 0 1 0\n")).colours.empty());  // normals
  EXPECT_TRUE(Model(io::decode_xyz("0 0 0 0.5 0 0.5\n1 0 0 255 0 0\n")).colours.empty());
  EXPECT_TRUE(Model(io::decode_xyz("0 0 0 255 0 256\n")).colours.empty());
}

TEST(Xyz, ABrokenLineIsNamed) {
  try {
    io::decode_xyz("0 0 0\n1 1 1\n2 2\n");
    FAIL();
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("line 3"), std::string::npos);
  }
}

}  // namespace
}  // namespace filmsticking::test
