// SPDX-License-Identifier: GPL-3.0-or-later
// Every format that is written is read back with the same numbers.
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "samples.h"

namespace filmsticking::test {
namespace {

TEST(Files, WrittenCloudsReadBackAsTheSamePointsAndNormals) {
  const ScratchFolder folder;
  for (const bool single : {true, false})
    for (const std::string kind : {"pcd", "ply"}) {
      SCOPED_TRACE(kind);
      const io::Cloud cloud = labelled(single);
      io::write_cloud(folder / ("a." + kind), cloud);
      const io::Cloud read = io::read_cloud(folder / ("a." + kind));
      EXPECT_TRUE(same_bits(io::positions_of(read.points), io::positions_of(cloud.points)));
      EXPECT_EQ(normals_in(read.points), normals_in(cloud.points));
      if (kind == "pcd") {
        EXPECT_EQ(read.points.width, 2u);
        EXPECT_EQ(read.viewpoint, cloud.viewpoint);
      }
    }
}

class RoundTrip : public ::testing::TestWithParam<std::tuple<const char*, bool>> {};

TEST_P(RoundTrip, KeepsEveryBit) {
  const auto [extension, single] = GetParam();
  const ScratchFolder folder;
  const std::string path = folder / ("mesh" + std::string(extension));
  const Model model = tetrahedron(single);
  io::write_mesh(path, model);
  const Model back = io::read_mesh(path);
  EXPECT_TRUE(same_bits(back.positions, model.positions));
  EXPECT_EQ(back.colours, model.colours);
  EXPECT_EQ(back.triangles, model.triangles);
  EXPECT_EQ(folder.count(), 1u);  // nothing left beside it
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip,
                         ::testing::Combine(::testing::Values(".ply", ".obj", ".vtk", ".PLY"),
                                            ::testing::Bool()),
                         [](const auto& variant) {
                           const std::string extension = std::get<0>(variant.param) + 1;
                           return extension + (std::get<1>(variant.param) ? "Single" : "Double");
                         });

TEST(RandomNumbers, ComeBackFromTextAndBinary) {
  std::mt19937_64 random(1);
  Model model;
  for (int i = 0; i < 3000; ++i) {
    Point p{};
    for (double& x : p) do {
        const std::uint64_t bits = random();
        std::memcpy(&x, &bits, sizeof x);
      } while (!std::isfinite(x));
    model.positions.push_back(p);
  }
  EXPECT_TRUE(
      same_bits(Model(io::decode_mesh("ply", io::encode_mesh("ply", model))).positions, model.positions));
  EXPECT_TRUE(
      same_bits(Model(io::decode_mesh("obj", io::encode_mesh("obj", model))).positions, model.positions));
}

}  // namespace
}  // namespace filmsticking::test
