// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ.
#include <gtest/gtest.h>

#include <cmath>

#include "samples.h"

namespace filmsticking::test {
namespace {

TEST(Obj, IsRead) {
  const Model model = io::decode_mesh(
      "obj",
      "# a comment\nmtllib none.mtl\no thing\nv 0.1 +2 3e0\nv 1 0 0 1.0\r\nv 0 1 0\nv -0.0 1 1\nvn 0 0 1\n"
      "vt 0 0\ns off\nf 1/1/1 2//1 3/1\nf -4 -3 -2 -1\n");
  ASSERT_EQ(model.positions.size(), 4u);
  EXPECT_EQ(model.positions[0], (Point{0.1, 2, 3}));
  EXPECT_TRUE(std::signbit(model.positions[3][0]));
  EXPECT_EQ(model.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(model.colours.empty());
}

TEST(Obj, BrokenFilesAreRefused) {
  for (const char* text :
       {"v 0 0\n", "v 0 0 zero\n", "v 0 0 0\nf 1 2 3\n", "v 0 0 0\nf 1 1 0\n", "v 0 0 0\nf 1 1 -2\n",
        "v 0 0 0\nf a b c\n", "v 0 0 0\nf 1 1 99999999999999999999\n"})
    EXPECT_THROW(io::decode_mesh("obj", text), IoError) << text;
}

TEST(Obj, AColourThatIsNoNumberIsNone) {
  EXPECT_EQ(Model(io::decode_mesh("obj", "v 0 0 0 nan 1 0.5\n")).colours,
            (std::vector<Colour>{{0, 255, 128}}));
}

TEST(Obj, KeepsNormalsOfPointsAndSaysThatThoseOfCornersAreLeftOut) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\n";
  for (const char* faces : {"", "f 1//1 2//2 3//3\n", "f -3//-3 2//2 3//3\n"}) {
    const io::Cloud cloud = io::decode_cloud("obj", points + faces);
    EXPECT_EQ(normals_in(cloud.points), (std::vector<std::array<float, 3>>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
    EXPECT_TRUE(cloud.notes.empty());
  }
  const io::Cloud cloud = io::decode_cloud("obj", points + "f 1//2 2//2 3//3\n");
  EXPECT_TRUE(normals_in(cloud.points).empty());
  EXPECT_EQ(cloud.notes.size(), 1u);
}

TEST(Obj, OfSevenNumbersTheFourthIsAWeightIfItIsOneEverywhere) {
  const auto colours = [](const char* text) { return Model(io::decode_mesh("obj", text)).colours; };
  EXPECT_EQ(colours("v 0 0 0 1 0.2 0.4 0.6\nv 1 0 0 1 1 1 1\n"),
            (std::vector<Colour>{{51, 102, 153}, {255, 255, 255}}));
  EXPECT_EQ(colours("v 0 0 0 1 0.2 0.4 1\nv 1 0 0 0 0.2 0.4 1\n"),
            (std::vector<Colour>{{255, 51, 102}, {0, 51, 102}}));
}

TEST(Obj, ColoursThatNotAllPointsHaveAreLeftOutWithANote) {
  const io::Cloud cloud = io::decode_cloud("obj", "v 0 0 0 1 1 1\nv 1 0 0\n");
  EXPECT_TRUE(io::colours_of(cloud.points).empty());
  EXPECT_EQ(cloud.notes.size(), 1u);
}

}  // namespace
}  // namespace filmsticking::test
