// SPDX-License-Identifier: GPL-3.0-or-later
// PCD.
#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

#include "samples.h"

namespace filmsticking::test {
namespace {

TEST(Files, PclReadsAWrittenPcd) {
  const ScratchFolder folder;
  const io::Cloud cloud = labelled(true);
  io::write_cloud(folder / "a.pcd", cloud);
  pcl::PointCloud<pcl::PointNormal> read;
  ASSERT_EQ(pcl::io::loadPCDFile(folder / "a.pcd", read), 0);
  ASSERT_EQ(read.size(), 4u);
  EXPECT_EQ(read.height, 2u);
  const std::vector<Point> places = io::positions_of(cloud.points);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(read[i].y, static_cast<float>(places[i][1]));
    EXPECT_EQ(read[i].normal_z, normals_in(cloud.points)[i][2]);
  }
}

TEST(Pcd, BunnyIsReadAsItsTextSays) {
  const Model model = io::read_cloud(TEST_DATA "/bun0.pcd");
  ASSERT_EQ(model.positions.size(), 397u);
  std::ifstream file(TEST_DATA "/bun0.pcd");
  std::string word;
  while (file >> word && word != "ascii") {
  }
  for (const Point& p : model.positions) {
    for (int k = 0; k < 7; ++k) {
      ASSERT_TRUE(file >> word);
      float value = 0;
      std::from_chars(word.data(), word.data() + word.size(), value);
      ASSERT_TRUE(k >= 3 || p[k] == value);
    }
  }
}

class PcdVariant : public ::testing::TestWithParam<int> {};

TEST_P(PcdVariant, KeepsBitsAndColours) {
  const Model expected = tetrahedron(true);
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  for (std::size_t i = 0; i < 4; ++i) {
    pcl::PointXYZRGB point;
    point.getVector3fMap() = Eigen::Map<const Eigen::Vector3d>(expected.positions[i].data()).cast<float>();
    point.r = expected.colours[i][0];
    point.g = expected.colours[i][1];
    point.b = expected.colours[i][2];
    cloud.push_back(point);
  }
  const ScratchFolder folder;
  const std::string path = folder / "cloud.pcd";
  pcl::PCDWriter writer;
  if (GetParam() == 0) writer.writeASCII(path, cloud, 9);
  if (GetParam() == 1) writer.writeBinary(path, cloud);
  if (GetParam() == 2) writer.writeBinaryCompressed(path, cloud);
  const Model model = io::read_cloud(path);
  EXPECT_TRUE(same_bits(model.positions, expected.positions));
  EXPECT_EQ(model.colours, expected.colours);
}

INSTANTIATE_TEST_SUITE_P(Formats, PcdVariant, ::testing::Values(0, 1, 2), [](const auto& variant) {
  return std::string(variant.param == 0 ? "Ascii" : variant.param == 1 ? "Binary" : "Compressed");
});

class PcdFields : public ::testing::TestWithParam<int> {};

TEST_P(PcdFields, AreAllKeptAsPclWritesThem) {
  pcl::PointCloud<pcl::PointXYZI> plain;
  for (int i = 0; i < 6; ++i) plain.push_back({1.5F * i, 0.1F, -3.25F, 0.3F + i});
  plain.width = 3, plain.height = 2;
  plain.sensor_origin_ = {1, 2, 3, 0};
  pcl::PCLPointCloud2 expected;
  pcl::toPCLPointCloud2(plain, expected);
  // In the padding of the point: a label, and a time stamp that double precision would round.
  expected.fields.push_back(io::make_field("label", 20, pcl::PCLPointField::UINT16, 2));
  expected.fields.push_back(io::make_field("stamp", 24, pcl::PCLPointField::UINT64));
  for (std::uint64_t i = 0; i < 6; ++i) {
    const std::uint64_t stamp = (std::uint64_t{1} << 60) + i;
    const std::uint16_t label[2] = {static_cast<std::uint16_t>(7 * i), 65535};
    std::memcpy(&expected.data[i * expected.point_step + 20], label, sizeof label);
    std::memcpy(&expected.data[i * expected.point_step + 24], &stamp, sizeof stamp);
  }
  const ScratchFolder folder;
  const std::string path = folder / "cloud.pcd";
  pcl::PCDWriter writer;
  const Eigen::Vector4f origin(1, 2, 3, 0);
  const Eigen::Quaternionf still = Eigen::Quaternionf::Identity();
  if (GetParam() == 0) writer.writeASCII(path, expected, origin, still, 9);
  if (GetParam() == 1) writer.writeBinary(path, expected, origin, still);
  if (GetParam() == 2) writer.writeBinaryCompressed(path, expected, origin, still);
  const io::Cloud read = io::read_cloud(path);
  EXPECT_EQ(read.viewpoint, (Point{1, 2, 3}));
  EXPECT_EQ(read.points.width, 3u);
  EXPECT_EQ(read.points.height, 2u);
  EXPECT_EQ(fields_of(read.points), fields_of(expected));
  for (std::size_t i = 0; i < 6; ++i)
    for (const pcl::PCLPointField& field : expected.fields)
      EXPECT_EQ(
          std::memcmp(io::bytes_of(read.points, i) + io::find_field(read.points, field.name.c_str())->offset,
                      &expected.data[i * expected.point_step + field.offset],
                      io::size_of(io::Scalar{field.datatype}) * field.count),
          0)
          << field.name << " of " << i;

  // PLY has no fields of several values, and no integers of 64 bits.
  const pcl::PCLPointCloud2 again =
      io::decode_mesh("ply", io::encode_mesh("ply", io::make_mesh(read.points, {}))).cloud;
  EXPECT_EQ(value_of<std::uint16_t>(again, "label_0", 5), 35);
  EXPECT_EQ(value_of<std::uint16_t>(again, "label_1", 5), 65535);
  EXPECT_EQ(value_of<double>(again, "stamp", 5), std::ldexp(1, 60));
}

INSTANTIATE_TEST_SUITE_P(Formats, PcdFields, ::testing::Values(0, 1, 2), [](const auto& variant) {
  return std::string(variant.param == 0 ? "Ascii" : variant.param == 1 ? "Binary" : "Compressed");
});

TEST(Pcd, TheOrderOfTheHeaderIsFree) {
  const io::Cloud cloud = io::decode_pcd(
      "# any\nFIELDS x y z ring\nHEIGHT 1\nCOUNT 1 1 1 2\nTYPE F I F U\nSIZE 4 4 8 1\nWIDTH 2\nDATA ascii\n"
      "0.1 -7 0.1 1 2\n1 2\n3 4 5\n");
  EXPECT_EQ(io::positions_of(cloud.points), (std::vector<Point>{{0.1F, -7, 0.1}, {1, 2, 3}}));
  EXPECT_EQ(value_of<std::uint8_t>(cloud.points, "ring", 1), 4);
}

TEST(Pcd, DoublesStayDouble) {
  const ScratchFolder folder;
  write_text(folder / "cloud.pcd",
             "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\n"
             "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n500000.1234567891 4649776.224740001 0.1\nnan "
             "nan nan\n");
  const Model model = io::read_cloud(folder / "cloud.pcd");
  ASSERT_EQ(model.positions.size(), 2u);
  EXPECT_EQ(model.positions[0], (Point{500000.1234567891, 4649776.224740001, 0.1}));
  EXPECT_TRUE(std::isnan(model.positions[1][2]));
}

TEST(Pcd, SaysWhereTheSensorWas) {
  const ScratchFolder folder;
  const auto viewpoint = [&](const std::string& line) {
    write_text(folder / "cloud.pcd",
               "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\n" + line +
                   "POINTS 1\nDATA ascii\n1 2 3\n");
    return io::read_cloud(folder / "cloud.pcd").viewpoint;
  };
  EXPECT_EQ(viewpoint("VIEWPOINT 1.5 -2 3e2 1 0 0 0\n"), (Point{1.5, -2, 300}));
  // It is a hint only.
  for (const char* line :
       {"", "VIEWPOINT 1 2\n", "VIEWPOINT 1 nan 2 1 0 0 0\n", "VIEWPOINT a b c\n", "VIEWPOINT 1 2 1e999\n"})
    EXPECT_FALSE(viewpoint(line)) << line;
}

TEST(Pcd, SaysWhereTheSensorOfEachPointWas) {
  const std::string
      header = "VERSION 0.7\nFIELDS x y z vp_x vp_y ",
      rest =
          "\nSIZE 4 4 4 4 4 8\nTYPE F F F F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n1 2 3 4 5 6.1\n1 2 3 7 8 9\n";
  EXPECT_EQ(io::decode_cloud("pcd", header + "vp_z" + rest).viewpoints,
            (std::vector<Point>{{4, 5, 6.1}, {7, 8, 9}}));
  EXPECT_TRUE(io::decode_cloud("pcd", header + "other" + rest).viewpoints.empty());
}

TEST(Pcd, BrokenFilesAreRefusedQuietly) {
  const ScratchFolder folder;
  const std::string fields = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
  const std::vector<std::string> broken = {
      "nothing like it",
      fields + "WIDTH 3\nHEIGHT 1\nPOINTS 3\n",                                       // no data
      fields + "WIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA ascii\n0 0 0\n",                    // too short
      fields + "WIDTH 2000000000\nHEIGHT 1\nPOINTS 2000000000\nDATA ascii\n0 0 0\n",  // an absurd number
      fields + "WIDTH 2000000000\nHEIGHT 1\nPOINTS 2000000000\nDATA binary\n012345678901",
      fields + "WIDTH 2000000000\nHEIGHT 1\nPOINTS 2000000000\nDATA binary_compressed\n0123456789",
      fields + "WIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA binary\n0123456789",
      fields + "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary_compressed\n0123456789",
      fields + "WIDTH two\nHEIGHT 1\nPOINTS two\nDATA ascii\n0 0 0\n",
      "VERSION 0.7\nFIELDS a b c\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA "
      "ascii\n0 0 0\n",
  };
  for (const std::string& text : broken) {
    write_text(folder / "cloud.pcd", text);
    ::testing::internal::CaptureStderr();
    EXPECT_NE(error_of(folder / "cloud.pcd"), "") << text;
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  }
}

TEST(Pcd, PointsThatTheHeaderDoesNotCountAreNoted) {
  const std::string header =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nDATA binary\n";
  EXPECT_TRUE(io::decode_pcd(header + std::string(12, '\0') + "\n").notes.empty());
  EXPECT_EQ(io::decode_pcd(header + std::string(24, '\0')).notes.size(), 1u);
}

TEST(Pcd, KeepsTheOrientationOfTheSensor) {
  io::Cloud cloud = labelled(true);
  cloud.orientation = {0.5, 0.5, -0.5, 0.5};
  const ScratchFolder folder;
  io::write_cloud(folder / "a.pcd", cloud);
  EXPECT_EQ(io::read_cloud(folder / "a.pcd").orientation, cloud.orientation);
}

}  // namespace
}  // namespace filmsticking::test
