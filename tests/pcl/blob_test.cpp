// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds whose fields the point type does not know: setInputBlob().
#include <gtest/gtest.h>
#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/surface/filmsticking_pp.h>

#include <array>
#include <atomic>
#include <cstring>

#include "clouds.h"
#include "filmsticking/reconstruct.h"

namespace filmsticking::test {
namespace {

using pcl::PCLPointCloud2;
using pcl::PCLPointField;
using pcl::PointXYZ;
using Class = pcl::FilmstickingPP<PointXYZ>;

constexpr std::size_t kRange = 0, kX = 8, kY = 12, kZ = 16, kRing = 20, kTag = 22, kStep = 28;

template <typename T>
T read(const PCLPointCloud2& blob, std::size_t point, std::size_t offset) {
  const std::size_t row = point / blob.width, column = point % blob.width;
  T value;
  std::memcpy(&value, &blob.data[row * blob.row_step + column * blob.point_step + offset], sizeof value);
  return value;
}

template <typename T>
void write(PCLPointCloud2& blob, std::size_t point, std::size_t offset, T value) {
  const std::size_t row = point / blob.width, column = point % blob.width;
  std::memcpy(&blob.data[row * blob.row_step + column * blob.point_step + offset], &value, sizeof value);
}

PCLPointField field(const char* name, std::size_t offset, std::uint8_t type, unsigned count = 1) {
  PCLPointField f;
  f.name = name;
  f.offset = static_cast<pcl::uindex_t>(offset);
  f.datatype = type;
  f.count = count;
  return f;
}

/// A sphere as a driver may send it: own fields, the coordinates not first, bytes unused, padded rows.
PCLPointCloud2::Ptr make_blob(unsigned width, unsigned height) {
  PCLPointCloud2::Ptr blob(new PCLPointCloud2);
  const auto sphere = make_sphere<PointXYZ>(static_cast<int>(width * height));
  blob->header = sphere->header;
  blob->width = width;
  blob->height = height;
  blob->fields = {
      field("range", kRange, PCLPointField::FLOAT64), field("x", kX, PCLPointField::FLOAT32),
      field("y", kY, PCLPointField::FLOAT32),         field("z", kZ, PCLPointField::FLOAT32),
      field("ring", kRing, PCLPointField::UINT16),    field("tag", kTag, PCLPointField::UINT8, 4)};
  blob->point_step = kStep;
  blob->row_step = width * kStep + 12;
  blob->data.assign(blob->row_step * height, 0);
  for (std::size_t i = 0; i < sphere->size(); ++i) {
    write(*blob, i, kRange, 0.5 + static_cast<double>(i));
    write(*blob, i, kX, (*sphere)[i].x);
    write(*blob, i, kY, (*sphere)[i].y);
    write(*blob, i, kZ, (*sphere)[i].z);
    write(*blob, i, kRing, static_cast<std::uint16_t>(3 * i));
    write(*blob, i, kTag, static_cast<std::uint32_t>(1000000 + i));
  }
  return blob;
}

TEST(Blob, FieldsThatThePointTypeDoesNotKnowAreKept) {
  const auto blob = make_blob(20, 10);
  Class filmsticking;
  filmsticking.setInputBlob(blob);
  EXPECT_EQ(filmsticking.getInputBlob(), blob);
  pcl::PolygonMesh mesh;
  filmsticking.reconstruct(mesh);
  ASSERT_EQ(filmsticking.getStatus(), Status::Ok) << filmsticking.getStatusMessage();
  EXPECT_EQ(mesh.polygons.size(), 396u);
  EXPECT_EQ(mesh.header.frame_id, "scanner");
  EXPECT_EQ(mesh.cloud.header.stamp, blob->header.stamp);
  ASSERT_EQ(mesh.cloud.width, 200u);
  EXPECT_EQ(mesh.cloud.height, 1u);
  EXPECT_EQ(mesh.cloud.row_step, 200 * kStep);
  EXPECT_EQ(mesh.cloud.data.size(), 200 * kStep);
  EXPECT_TRUE(mesh.cloud.is_dense);
  ASSERT_EQ(mesh.cloud.fields.size(), blob->fields.size());
  for (std::size_t f = 0; f < blob->fields.size(); ++f) {
    EXPECT_EQ(mesh.cloud.fields[f].name, blob->fields[f].name);
    EXPECT_EQ(mesh.cloud.fields[f].offset, blob->fields[f].offset);
  }
  for (std::size_t k = 0; k < 200; ++k) {
    const auto id = static_cast<std::size_t>(filmsticking.getVertexIndices()[k]);
    EXPECT_EQ(read<double>(mesh.cloud, k, kRange), 0.5 + static_cast<double>(id));
    EXPECT_EQ(read<std::uint16_t>(mesh.cloud, k, kRing), 3 * id);
    EXPECT_EQ(read<std::uint32_t>(mesh.cloud, k, kTag), 1000000 + id);
    for (const std::size_t offset : {kX, kY, kZ})
      EXPECT_EQ(read<std::uint32_t>(mesh.cloud, k, offset), read<std::uint32_t>(*blob, id, offset));
  }
}

TEST(Blob, MakesTheSurfaceThatItsCloudMakes) {
  const auto blob = make_blob(20, 10);
  pcl::PointCloud<PointXYZ>::Ptr cloud(new pcl::PointCloud<PointXYZ>);
  pcl::fromPCLPointCloud2(*blob, *cloud);
  Class from_blob, from_cloud;
  from_blob.setInputBlob(blob);
  from_cloud.setInputCloud(cloud);
  from_blob.setIndices(2, 2, 8, 15);
  from_cloud.setIndices(2, 2, 8, 15);
  pcl::PointCloud<PointXYZ> points;
  std::vector<pcl::Vertices> polygons, expected;
  from_blob.reconstruct(points, polygons);
  from_cloud.reconstruct(points, expected);
  ASSERT_FALSE(expected.empty());
  ASSERT_EQ(polygons.size(), expected.size());
  for (std::size_t t = 0; t < polygons.size(); ++t) EXPECT_EQ(polygons[t].vertices, expected[t].vertices);
  EXPECT_EQ(from_blob.getVertexIndices(), from_cloud.getVertexIndices());
}

/// The fields x, y and z at the offsets `places`.
PCLPointCloud2::Ptr with_coordinates_at(const PCLPointCloud2& blob, std::array<std::size_t, 3> places) {
  PCLPointCloud2::Ptr moved(new PCLPointCloud2(blob));
  for (std::size_t k = 0; k < 3; ++k) moved->fields[1 + k].offset = static_cast<pcl::uindex_t>(places[k]);
  const std::size_t from[] = {kX, kY, kZ};
  for (std::size_t i = 0; i < blob.width * blob.height; ++i)
    for (std::size_t k = 0; k < 3; ++k) write(*moved, i, places[k], read<float>(blob, i, from[k]));
  return moved;
}

TEST(Blob, IsReadWhereverItsCoordinatesLie) {
  const auto blob = make_blob(20, 10);
  Class filmsticking;
  filmsticking.setInputBlob(blob);
  EXPECT_EQ(filmsticking.getInputCloud(), nullptr);
  pcl::PointCloud<PointXYZ> points, expected_points;
  std::vector<pcl::Vertices> polygons, expected;
  filmsticking.reconstruct(expected_points, expected);
  ASSERT_EQ(expected.size(), 396u);
  EXPECT_EQ(expected_points.header.frame_id, "scanner");
  EXPECT_TRUE(expected_points.is_dense);
  for (const std::array<std::size_t, 3>& places :
       {std::array<std::size_t, 3>{kZ, kY, kX}, {kX, kRing, kZ}, {3, 7, 11}}) {
    filmsticking.setInputBlob(with_coordinates_at(*blob, places));
    filmsticking.reconstruct(points, polygons);
    ASSERT_EQ(polygons.size(), expected.size());
    for (std::size_t t = 0; t < polygons.size(); ++t) EXPECT_EQ(polygons[t].vertices, expected[t].vertices);
    ASSERT_EQ(points.size(), expected_points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
      EXPECT_EQ(points[k].getVector3fMap(), expected_points[k].getVector3fMap());
  }
}

/// The blob with x, y, z of type FLOAT64 behind its other fields, moved far away.
PCLPointCloud2::Ptr with_doubles(const PCLPointCloud2& blob, const std::array<std::size_t, 3>& places) {
  PCLPointCloud2::Ptr far(new PCLPointCloud2(blob));
  far->point_step = 64;
  far->row_step = 64 * blob.width + 8;
  far->data.assign(std::size_t{far->row_step} * blob.height, 0);
  const double shift[3] = {500000.1, 4649776.7, 123.4};
  const std::size_t from[3] = {kX, kY, kZ};
  for (std::size_t i = 0; i < std::size_t{blob.width} * blob.height; ++i) {
    write(*far, i, kRing, read<std::uint16_t>(blob, i, kRing));
    for (std::size_t k = 0; k < 3; ++k)
      write(*far, i, places[k], shift[k] + double{read<float>(blob, i, from[k])});
  }
  for (std::size_t k = 0; k < 3; ++k) {
    far->fields[1 + k].datatype = PCLPointField::FLOAT64;
    far->fields[1 + k].offset = static_cast<pcl::uindex_t>(places[k]);
  }
  return far;
}

TEST(Blob, DoubleCoordinatesAreReadAndKeptWithAllTheirDigits) {
  const auto blob = make_blob(20, 10);
  for (const std::array<std::size_t, 3>& places :
       {std::array<std::size_t, 3>{32, 40, 48}, {48, 32, 40}, {29, 41, 53}}) {
    const auto far = with_doubles(*blob, places);
    std::vector<filmsticking::Point> positions;
    for (std::size_t i = 0; i < 200; ++i)
      positions.push_back({read<double>(*far, i, places[0]), read<double>(*far, i, places[1]),
                           read<double>(*far, i, places[2])});
    Class filmsticking;
    filmsticking.setInputBlob(far);
    filmsticking.useNoViewPoint();
    pcl::PCLPointCloud2 vertices;
    std::vector<filmsticking::Triangle> triangles;
    filmsticking.reconstruct(vertices, triangles);
    ASSERT_EQ(filmsticking.getStatus(), Status::Ok) << filmsticking.getStatusMessage();
    EXPECT_EQ(triangles, filmsticking::reconstruct(positions).triangles);
    ASSERT_EQ(vertices.width, 200u);
    EXPECT_EQ(vertices.fields[1].datatype, PCLPointField::FLOAT64);
    for (std::size_t k = 0; k < 200; ++k) {
      const auto id = static_cast<std::size_t>(filmsticking.getVertexIndices()[k]);
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(read<double>(vertices, k, places[axis]), positions[id][axis]);
      EXPECT_EQ(read<std::uint16_t>(vertices, k, kRing), 3 * id);
    }
    // PCL's point types round them.
    pcl::PointCloud<PointXYZ> points;
    std::vector<pcl::Vertices> polygons;
    filmsticking.reconstruct(points, polygons);
    ASSERT_EQ(polygons.size(), triangles.size());
    for (std::size_t k = 0; k < points.size(); ++k)
      EXPECT_EQ(points[k].y, static_cast<float>(
                                 positions[static_cast<std::size_t>(filmsticking.getVertexIndices()[k])][1]));
  }
}

TEST(Blob, TrianglesAreThoseOfThePolygonMesh) {
  Class filmsticking;
  filmsticking.setInputBlob(make_blob(20, 10));
  pcl::PolygonMesh mesh;
  filmsticking.reconstruct(mesh);
  pcl::PCLPointCloud2 vertices;
  std::vector<filmsticking::Triangle> triangles;
  filmsticking.reconstruct(vertices, triangles);
  EXPECT_EQ(vertices.data, mesh.cloud.data);
  ASSERT_EQ(triangles.size(), mesh.polygons.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    EXPECT_EQ(mesh.polygons[t].vertices, pcl::Indices(triangles[t].begin(), triangles[t].end()));

  filmsticking.setInputBlob(nullptr);
  ::testing::internal::CaptureStderr();
  filmsticking.reconstruct(vertices, triangles);
  ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(filmsticking.getStatus(), Status::InvalidInput);
  EXPECT_TRUE(triangles.empty());
  EXPECT_TRUE(vertices.data.empty());
}

TEST(Blob, AFlagOfTheCallersStopsItAndEveryStepIsShown) {
  Class filmsticking;
  filmsticking.setInputBlob(make_blob(20, 10));
  filmsticking.setFilmStart(Class::FilmStart::Sphere);
  int steps = 0;
  filmsticking.setStepCallback([&steps](int step, const filmsticking::Mesh& film) {
    EXPECT_EQ(step, steps++);
    EXPECT_FALSE(film.triangles.empty());
  });
  pcl::PolygonMesh mesh;
  filmsticking.reconstruct(mesh);
  EXPECT_EQ(filmsticking.getStatus(), Status::Ok);
  EXPECT_GT(steps, 1);

  const std::atomic<bool> stop{true};
  filmsticking.setCancelFlag(&stop);
  ::testing::internal::CaptureStderr();
  filmsticking.reconstruct(mesh);
  ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(filmsticking.getStatus(), Status::Cancelled);
  filmsticking.setCancelFlag(nullptr);
  steps = 0;
  filmsticking.reconstruct(mesh);
  EXPECT_EQ(filmsticking.getStatus(), Status::Ok);
}

TEST(Blob, ACloudSetLaterTakesItsPlace) {
  Class filmsticking;
  filmsticking.setInputBlob(make_blob(20, 10));
  filmsticking.setInputCloud(make_sphere<PointXYZ>(150));
  EXPECT_EQ(filmsticking.getInputBlob(), nullptr);
  pcl::PolygonMesh mesh;
  filmsticking.reconstruct(mesh);
  EXPECT_EQ(mesh.cloud.width, 150u);
  EXPECT_EQ(mesh.cloud.fields.size(), 3u);
}

void expect_refused(const PCLPointCloud2::ConstPtr& blob, Status status = Status::InvalidInput) {
  Class filmsticking;
  filmsticking.setInputBlob(blob);
  pcl::PolygonMesh mesh;
  mesh.polygons.resize(3);
  ::testing::internal::CaptureStderr();
  filmsticking.reconstruct(mesh);
  const std::string errors = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
  EXPECT_EQ(filmsticking.getStatus(), status) << filmsticking.getStatusMessage();
  EXPECT_TRUE(mesh.polygons.empty());
  EXPECT_TRUE(mesh.cloud.data.empty());
}

TEST(Blob, OneThatCannotBeReadFails) {
  expect_refused(nullptr);
  expect_refused(PCLPointCloud2::Ptr(new PCLPointCloud2));
  const auto change = [](auto edit) {
    const auto blob = make_blob(20, 10);
    edit(*blob);
    expect_refused(blob);
  };
  change([](PCLPointCloud2& b) { b.is_bigendian = 1; });
  change([](PCLPointCloud2& b) { b.fields[2].name = "q"; });
  change([](PCLPointCloud2& b) { b.fields[1].datatype = PCLPointField::FLOAT64; });
  change([](PCLPointCloud2& b) { b.fields[3].offset = kStep - 2; });
  change([](PCLPointCloud2& b) { b.fields[4].offset = 0xfffffffe; });
  change([](PCLPointCloud2& b) { b.fields[5].count = 0xffffffff; });
  change([](PCLPointCloud2& b) { b.data.resize(b.data.size() - 1); });
  change([](PCLPointCloud2& b) { b.data.resize(b.data.size() + 1); });
  change([](PCLPointCloud2& b) { b.row_step = 3; });
  change([](PCLPointCloud2& b) { b.width = 0xffffffff; });
  change([](PCLPointCloud2& b) { b.height = 0xffffffff; });
  change([](PCLPointCloud2& b) { b.point_step = 0; });
}

TEST(Blob, OneWithoutPointsHasTooFew) {
  const auto blob = make_blob(20, 10);
  blob->width = blob->height = blob->row_step = 0;
  blob->data.clear();
  expect_refused(blob, Status::TooFewPoints);
}

TEST(Blob, OneThatChangesAfterItWasSetFails) {
  const auto blob = make_blob(20, 10);
  Class filmsticking;
  filmsticking.setInputBlob(blob);
  blob->data.resize(100);
  pcl::PolygonMesh mesh;
  ::testing::internal::CaptureStderr();
  filmsticking.reconstruct(mesh);
  ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(filmsticking.getStatus(), Status::InvalidInput);
  EXPECT_TRUE(mesh.polygons.empty());
}

}  // namespace
}  // namespace filmsticking::test
