// SPDX-License-Identifier: GPL-3.0-or-later
// STL.
#include <gtest/gtest.h>

#include <cstring>

#include "samples.h"

namespace filmsticking::test {
namespace {

TEST(Stl, SinglePrecisionIsBinaryAndKeepsEveryBit) {
  const Model model = tetrahedron(true);
  const std::string bytes = io::encode_mesh("stl", model);
  ASSERT_EQ(bytes.size(), 84u + 50u * model.triangles.size());
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      float corner[3];
      std::memcpy(corner, bytes.data() + 84 + 50 * t + 12 + 12 * k, sizeof corner);
      for (std::size_t a = 0; a < 3; ++a) EXPECT_EQ(corner[a], model.positions[model.triangles[t][k]][a]);
    }
}

TEST(Stl, DoublePrecisionIsTextAndKeepsEveryBit) {
  const Model model = tetrahedron(false);
  const std::string bytes = io::encode_mesh("stl", model);
  EXPECT_EQ(bytes.rfind("solid", 0), 0u);
  EXPECT_TRUE(same_bits(corners(io::decode_mesh("stl", bytes)), corners(model)));
}

TEST(Stl, EqualCornersBecomeOneVertex) {
  const Model back = io::decode_mesh("stl", io::encode_mesh("stl", tetrahedron(true)));
  EXPECT_EQ(back.positions.size(), 4u);
  EXPECT_TRUE(same_bits(corners(back), corners(tetrahedron(true))));
}

TEST(Stl, ABinaryFileMayBeginWithSolid) {
  std::string bytes = io::encode_mesh("stl", tetrahedron(true));
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(Model(io::decode_mesh("stl", bytes)).triangles.size(), 4u);
  EXPECT_EQ(
      Model(io::decode_mesh("stl", io::encode_mesh("stl", tetrahedron(true)) + "and more")).triangles.size(),
      4u);
}

TEST(Stl, BrokenFilesAreRefused) {
  const std::string binary = io::encode_mesh("stl", tetrahedron(true));
  for (std::size_t size = 0; size < binary.size(); ++size)
    EXPECT_THROW(io::decode_mesh("stl", binary.substr(0, size)), IoError) << size;
  for (const char* text : {"solid\nendsolid\n", "solid\nvertex 0 0 0\nvertex 1 0 0\n",
                           "solid\nvertex 0 zero 0\n", "solid\nvertex 0 0 nan\nvertex 0 0 1\nvertex 1 0 1\n"})
    EXPECT_THROW(io::decode_mesh("stl", text), IoError) << text;
}

TEST(Stl, TextMayBeInCapitalsAndNameItselfAVertex) {
  const Model model =
      io::decode_mesh("stl",
                      "solid vertex 1 2\n  FACET NORMAL 0 0 1\n OUTER LOOP\n VERTEX 0 0 0\n VERTEX 1 0 0\n"
                      " VERTEX -0.0 1e0 0\n ENDLOOP\n ENDFACET\nendsolid vertex\n");
  EXPECT_EQ(model.positions, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(model.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(Stl, ManyCornersAreFoundAgain) {
  constexpr int kSide = 200;
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  for (int i = 0; i < kSide; ++i)
    for (int k = 0; k < kSide; ++k) {
      points.push_back({i * 0.5, k * 0.25, 1.0 / (1 << (i % 5))});
      const int at = i * kSide + k;
      if (i == 0 || k == 0) continue;
      triangles.push_back({at, at - 1, at - kSide});
      triangles.push_back({at - 1, at - kSide - 1, at - kSide});
    }
  const Model model{points, {}, triangles};
  const Model back = io::decode_mesh("stl", io::encode_mesh("stl", model));
  EXPECT_EQ(back.positions.size(), points.size());
  EXPECT_TRUE(same_bits(corners(back), corners(model)));
}

}  // namespace
}  // namespace filmsticking::test
