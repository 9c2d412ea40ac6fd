// SPDX-License-Identifier: GPL-3.0-or-later
// Files of points and meshes: every format read, every format written and read back with the same numbers.
#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "io/codecs.h"
#include "io/files.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "support/model.h"
#include "support/scratch_folder.h"

namespace filmsticking::test {
namespace {

using io::Colour;
using io::IoError;

/// A tetrahedron with awkward coordinates, in double or rounded to single precision.
Model tetrahedron(bool single) {
  Model model;
  model.positions = {{1.0 / 3, -2e-7, 500000.1234567891},
                     {M_PI, 1e-30, 4649776.224740001},
                     {-0.1, 7.25, 4649776.2},
                     {0, 1e17 / 7, -1.0 / 7}};
  if (single)
    for (Point& p : model.positions)
      for (double& x : p) x = static_cast<float>(x);
  model.colours = {Colour{0, 1, 2}, Colour{253, 254, 255}, Colour{127, 128, 129}, Colour{10, 200, 30}};
  model.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return model;
}

/// The same bits: -0 is not 0.
bool same_bits(const std::vector<Point>& a, const std::vector<Point>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0;
}

/// The corners of the triangles, one after the other.
std::vector<Point> corners(const Model& model) {
  std::vector<Point> points;
  for (const Triangle& t : model.triangles)
    for (const int k : t) points.push_back(model.positions[k]);
  return points;
}

void write_text(const std::string& path, std::string_view text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string error_of(const std::string& path) {
  try {
    io::read_cloud(path);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

/// Every point with normals, a label and rows, in double or single precision.
io::Cloud labelled(bool single) {
  const std::vector<Point> places = tetrahedron(single).positions;
  io::Cloud cloud{
      io::with_normals(io::make_cloud(places), {{0, 0, 1}, {0, 1, 0}, {0.6F, 0, -0.8F}, {1, 0, 0}}),
      Point{1, 2, 1.0 / 3}};
  cloud.points.width = cloud.points.height = 2;
  cloud.points.row_step = 2 * cloud.points.point_step;
  return cloud;
}

std::vector<std::array<float, 3>> normals_in(const pcl::PCLPointCloud2& cloud) {
  std::vector<std::array<float, 3>> normals(io::size_of(cloud));
  for (std::size_t i = 0; i < normals.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const char* names[] = {"normal_x", "normal_y", "normal_z"};
      const pcl::PCLPointField* field = io::find_field(cloud, names[axis]);
      if (field == nullptr) return {};
      normals[i][static_cast<std::size_t>(axis)] = io::load<float>(io::bytes_of(cloud, i) + field->offset);
    }
  return normals;
}

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

TEST(Files, NewNormalsReplaceOldOnes) {
  const io::Cloud cloud = labelled(true);
  const std::vector<std::array<float, 3>> turned(4, {0, -1, 0});
  const pcl::PCLPointCloud2 again = io::with_normals(cloud.points, turned);
  EXPECT_EQ(again.fields.size(), cloud.points.fields.size());
  EXPECT_EQ(normals_in(again), turned);
  EXPECT_EQ(io::positions_of(again), io::positions_of(cloud.points));
}

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

// ---- writing and reading back
// -------------------------------------------------------------------------------

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

TEST(Ply, CoordinatesAreFloatWhereThatKeepsThem) {
  EXPECT_NE(io::encode_mesh("ply", tetrahedron(true)).find("property float x"), std::string::npos);
  EXPECT_NE(io::encode_mesh("ply", tetrahedron(false)).find("property double x"), std::string::npos);
  Model far;
  far.positions = {{1e300, 0, 0}};
  EXPECT_TRUE(same_bits(Model(io::decode_mesh("ply", io::encode_mesh("ply", far))).positions, far.positions));
}

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

// ---- PLY
// ------------------------------------------------------------------------------------------------------

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

/// The value of a field at a point, as its own type.
template <typename T>
T value_of(const pcl::PCLPointCloud2& cloud, const char* name, std::size_t point) {
  const pcl::PCLPointField* field = io::find_field(cloud, name);
  T value{};
  if (field) std::memcpy(&value, io::bytes_of(cloud, point) + field->offset, sizeof value);
  return value;
}

std::vector<std::pair<std::string, int>> fields_of(const pcl::PCLPointCloud2& cloud) {
  std::vector<std::pair<std::string, int>> fields;
  for (const pcl::PCLPointField& field : cloud.fields) fields.emplace_back(field.name, field.datatype);
  return fields;
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

// ---- OBJ, XYZ
// -----------------------------------------------------------------------------------------------

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

// ---- PCD
// ------------------------------------------------------------------------------------------------------

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

// ---- files
// ------------------------------------------------------------------------------------------------------

TEST(Formats, MessagesListAllThatCanBeReadOrWritten) {
  const ScratchFolder folder;
  write_text(folder / "cloud.foo", "prose without numbers");
  const auto message = [](const auto& work) -> std::string {
    try {
      work();
    } catch (const IoError& error) {
      return error.what();
    }
    return "";
  };
  const std::string path = folder / "cloud.foo";
  const std::string none =
      "its content is of no format that is read: pcd ply obj stl vtk off las ptx pts xyz "
      "txt csv asc grid";
  EXPECT_EQ(message([&] { io::read_cloud(path); }), none);
  EXPECT_EQ(message([&] { io::read_mesh(path); }), none);
  EXPECT_EQ(message([&] { io::read_model(path); }), none);
  EXPECT_EQ(message([&] { io::write_mesh(path, tetrahedron(true)); }),
            "its extension is none of " + io::extensions_of(io::mesh_formats()));
  EXPECT_EQ(io::extensions_of(io::mesh_formats()), ".ply .obj .stl .vtk .glb");
}

TEST(Formats, AMeshIsSentInPiecesOfItsSize) {
  Model model;
  for (int i = 0; i < 20000; ++i) {
    model.positions.push_back({i / 3.0, 0.1 * (i % 7), -i / 7.0});
    model.colours.push_back({static_cast<std::uint8_t>(i), 1, 2});
    model.triangles.push_back({i, (i + 1) % 20000, (i + 2) % 20000});
  }
  const pcl::PolygonMesh mesh = model;
  for (const std::string& format : io::mesh_formats()) {
    if (format == "vtk") continue;  // VTK's writer makes it whole
    std::size_t most = 0;
    std::string sent;
    io::encode_mesh(format, mesh.cloud, model.triangles, [&](std::string_view piece) {
      most = std::max(most, piece.size());
      sent += piece;
    });
    EXPECT_GT(sent.size(), 400000u) << format;
    EXPECT_LT(most, 70000u) << format;
    EXPECT_EQ(sent, io::encode_mesh(format, model)) << format;
  }
}

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
