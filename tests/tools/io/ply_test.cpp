// SPDX-License-Identifier: GPL-3.0-or-later
// PLY.
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "samples.h"

namespace filmsticking::test {
namespace {

std::string ply_header(const std::string& format, const std::string& type, int vertices, int faces) {
  return "ply\nformat " + format + " 1.0\ncomment made for a test\nelement vertex " +
         std::to_string(vertices) + "\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type +
         " z\nelement face " + std::to_string(faces) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

template <typename T>
void append(std::string& bytes, T value, bool big_endian) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (big_endian) std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

TEST(Ply, CoordinatesAreFloatWhereThatKeepsThem) {
  EXPECT_NE(io::encode_mesh("ply", tetrahedron(true)).find("property float x"), std::string::npos);
  EXPECT_NE(io::encode_mesh("ply", tetrahedron(false)).find("property double x"), std::string::npos);
  Model far;
  far.positions = {{1e300, 0, 0}};
  EXPECT_TRUE(same_bits(Model(io::decode_mesh("ply", io::encode_mesh("ply", far))).positions, far.positions));
}

class PlyVariant : public ::testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(PlyVariant, IsReadToTheLastBit) {
  const std::string format = std::get<0>(GetParam()), type = std::get<1>(GetParam());
  const bool single = type == "float";
  const Model model = tetrahedron(single);
  std::string bytes = ply_header(format, type, 4, 2);
  if (format == "ascii") {
    char line[200];
    for (const Point& p : model.positions) {
      std::snprintf(line, sizeof line, single ? "%.9g %.9g %.9g\n" : "%.17g %.17g %.17g\n", p[0], p[1], p[2]);
      bytes += line;
    }
    bytes += "3 0 1 2\n4 0 1 2 3\n";
  } else {
    const bool big = format == "binary_big_endian";
    for (const Point& p : model.positions)
      for (const double x : p) {
        if (single) {
          append(bytes, static_cast<float>(x), big);
        } else {
          append(bytes, x, big);
        }
      }
    append(bytes, std::uint8_t{3}, big);
    for (const int k : {0, 1, 2}) append(bytes, k, big);
    append(bytes, std::uint8_t{4}, big);
    for (const int k : {0, 1, 2, 3}) append(bytes, k, big);
  }
  const Model back = io::decode_mesh("ply", bytes);
  EXPECT_TRUE(same_bits(back.positions, model.positions));
  EXPECT_EQ(back.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}}));
}

INSTANTIATE_TEST_SUITE_P(Formats, PlyVariant,
                         ::testing::Combine(::testing::Values("ascii", "binary_little_endian",
                                                              "binary_big_endian"),
                                            ::testing::Values("float", "double")),
                         [](const auto& variant) {
                           return std::string(std::get<0>(variant.param)) + "_" + std::get<1>(variant.param);
                         });

TEST(Ply, OtherPropertiesAndElementsAreSkipped) {
  const Model model = io::decode_mesh(
      "ply",
      "ply\r\nformat ascii 1.0\r\nobj_info x\r\nelement camera 1\r\nproperty float a\r\nelement vertex 2\r\n"
      "property uchar red\r\nproperty int x\r\nproperty list uchar float weights\r\nproperty float y\r\n"
      "property uchar green\r\nproperty uchar blue\r\nproperty double z\r\nelement edge 1\r\n"
      "property int vertex1\r\nproperty int vertex2\r\nend_header\r\n"
      "9\r\n1 10 2 0.5 0.5 20 2 3 30.5\r\n4 -11 0 nan 5 6 31.5\r\n0 1\r\n");
  ASSERT_EQ(model.positions.size(), 2u);
  EXPECT_EQ(model.positions[0], (Point{10, 20, 30.5}));
  EXPECT_TRUE(std::isnan(model.positions[1][1]));
  EXPECT_EQ(model.colours, (std::vector<Colour>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(Ply, AllScalarPropertiesAreKeptUnderTheirNamesAndTypes) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float intensity\nproperty float x\n"
      "property float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n"
      "property uint label\nproperty double time\nproperty short odd\nend_header\n";
  const std::string bytes = header +
                            "0.5 1 2 3 0.1 0.2 0.3 9 8 7 6 4000000000 1.0000000000000002 -5\n"
                            "nan 4 5 6 1 0 0 1 2 3 4 7 0.1 32767\n";
  using Type = pcl::PCLPointField;
  const std::vector<std::pair<std::string, int>> expected = {
      {"x", Type::FLOAT32},         {"y", Type::FLOAT32},        {"z", Type::FLOAT32},
      {"intensity", Type::FLOAT32}, {"normal_x", Type::FLOAT32}, {"normal_y", Type::FLOAT32},
      {"normal_z", Type::FLOAT32},  {"rgba", Type::UINT32},      {"label", Type::UINT32},
      {"time", Type::FLOAT64},      {"odd", Type::INT16}};
  const pcl::PolygonMesh read = io::decode_mesh("ply", bytes);
  const std::string written = io::encode_mesh("ply", read);
  for (const char* property : {"uint label", "float nx", "uchar red", "uchar alpha", "short odd"})
    EXPECT_NE(written.find(std::string("property ") + property + "\n"), std::string::npos) << property;
  for (const pcl::PCLPointCloud2& cloud : {read.cloud, io::decode_mesh("ply", written).cloud}) {
    EXPECT_EQ(fields_of(cloud), expected);
    EXPECT_EQ(value_of<float>(cloud, "intensity", 0), 0.5F);
    EXPECT_TRUE(std::isnan(value_of<float>(cloud, "intensity", 1)));
    EXPECT_EQ(value_of<float>(cloud, "normal_z", 0), 0.3F);
    EXPECT_EQ(value_of<std::uint32_t>(cloud, "rgba", 0), 0x06090807U);
    EXPECT_EQ(value_of<std::uint32_t>(cloud, "label", 0), 4000000000U);
    EXPECT_EQ(value_of<double>(cloud, "time", 0), 1.0000000000000002);
    EXPECT_EQ(value_of<std::int16_t>(cloud, "odd", 0), -5);
    EXPECT_EQ(io::positions_of(cloud), (std::vector<Point>{{1, 2, 3}, {4, 5, 6}}));
  }
}

TEST(Ply, CoordinatesOfWholeNumbersBecomeDoubles) {
  const pcl::PolygonMesh mesh = io::decode_mesh(
      "ply",
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty float y\nproperty uint z\n"
      "property uchar ring\nend_header\n-2147483647 0.1 4294967295 200\n");
  EXPECT_EQ(io::positions_of(mesh.cloud), (std::vector<Point>{{-2147483647, 0.1F, 4294967295}}));
  EXPECT_EQ(value_of<std::uint8_t>(mesh.cloud, "ring", 0), 200);
}

TEST(Ply, NumbersThatTheirTypeCannotHoldAreRefused) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
  for (const auto& [type, value] : {std::pair{"uchar", "256"},
                                    {"char", "-129"},
                                    {"ushort", "-1"},
                                    {"short", "40000"},
                                    {"uint", "nan"},
                                    {"int", "1e30"}})
    EXPECT_THROW(
        io::decode_mesh("ply", header + "property " + type + " a\nend_header\n0 0 0 " + value + "\n"),
        IoError)
        << type << " " << value;
}

TEST(Ply, TextIsRoundedOnceToTheDeclaredType) {
  // Halfway between two floats but for the last digit: by way of double it would fall to the wrong side.
  const std::string text = "1.00000005960464477540";
  const Model model = io::decode_mesh("ply", ply_header("ascii", "float", 1, 0) + text + " 0 0\n");
  float expected = 0;
  std::from_chars(text.data(), text.data() + text.size(), expected);
  EXPECT_EQ(model.positions[0][0], expected);
}

TEST(Ply, AnEarlierFileWithFacesFirstIsRead) {
  const Model model = io::decode_mesh(
      "ply",
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar uint vertex_index\nelement vertex 3\n"
      "property float x\nproperty float y\nproperty float z\nend_header\n3 2 1 0\n0 0 0\n1 0 0\n0 1 0\n");
  EXPECT_EQ(model.triangles, (std::vector<Triangle>{{2, 1, 0}}));
}

TEST(Ply, BrokenFilesAreRefused) {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  const std::vector<std::string> broken = {
      "",
      "plx\n",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n",  // no end of header
      ply_header("ascii", "float", 4, 0) + vertices,                  // a vertex is missing
      ply_header("ascii", "float", 2000000000, 0) + vertices,         // an absurd number
      ply_header("binary_little_endian", "float", 2000000000, 0) + vertices,
      ply_header("ascii", "float", -3, 0) + vertices,
      ply_header("ascii", "wide", 3, 0) + vertices,                 // unknown type
      ply_header("zipped", "float", 3, 0) + vertices,               // unknown format
      ply_header("ascii", "float", 3, 1) + vertices + "3 0 1 3\n",  // no such vertex
      ply_header("ascii", "float", 3, 1) + vertices + "3 0 1 -1\n",
      ply_header("ascii", "float", 3, 1) + vertices + "200000000 0 1 2\n",  // an absurd length
      ply_header("ascii", "float", 3, 1) + vertices + "-1 0 1 2\n",
      ply_header("ascii", "float", 3, 0) + "0 0 0\n1 zero 0\n0 1 0\n",               // not a number
      "ply\nformat ascii 1.0\nproperty float x\nend_header\n",                       // of what element?
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",  // no y and z
  };
  for (const std::string& bytes : broken) EXPECT_THROW(io::decode_mesh("ply", bytes), IoError) << bytes;
  const std::string whole = io::encode_mesh("ply", tetrahedron(false));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW(io::decode_mesh("ply", std::string_view(whole).substr(0, size)), IoError) << size;
}

TEST(Ply, ColoursThatAreNoBytesAreRefused) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n0 0 0 ";
  EXPECT_EQ(Model(io::decode_mesh("ply", header + "0 128 255\n")).colours,
            (std::vector<Colour>{{0, 128, 255}}));
  for (const char* colour : {"0 256 0", "-1 0 0", "0 0 nan", "1e300 0 0"})
    EXPECT_THROW(io::decode_mesh("ply", header + colour), IoError) << colour;
}

TEST(Ply, FacesOfVerticesThatOnlyTheHeaderHasAreRefused) {
  const std::string begin = "ply\nformat ascii 1.0\n", vertices = "element vertex 3\n",
                    xyz = "property float x\nproperty float y\nproperty float z\n",
                    faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n",
                    points = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(
      Model(io::decode_mesh("ply", begin + vertices + xyz + faces + points + "3 0 1 2\n")).triangles.size(),
      1u);
  EXPECT_THROW(io::decode_mesh("ply", begin + vertices + faces + "3 0 1 2\n"),
               IoError);  // without properties
  EXPECT_THROW(io::decode_mesh("ply", begin + vertices + xyz + "element vertex 6\n" + xyz + faces + points +
                                          points + points + "3 0 1 5\n"),
               IoError);  // there are two kinds of them
}

}  // namespace
}  // namespace filmsticking::test
