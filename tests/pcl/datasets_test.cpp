// SPDX-License-Identifier: GPL-3.0-or-later
// What the class promises, on the clouds whose files are given as arguments.
#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>
#include <pcl/surface/filmsticking_pp.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh.h"
#include "support/surface_check.h"

namespace filmsticking::test {
namespace {

std::vector<std::string> files;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

pcl::PolygonMesh reconstruct(pcl::FilmstickingPP<pcl::PointXYZ>& film, int threads) {
  pcl::PolygonMesh mesh;
  film.setNumberOfThreads(threads);
  film.reconstruct(mesh);
  return mesh;
}

class Dataset : public ::testing::TestWithParam<std::string> {};

TEST_P(Dataset, KeepsThePromise) {
  const std::string& file = GetParam();
  if (file.empty()) GTEST_SKIP() << "no file is given: set FILMSTICKING_DATA to a folder of clouds";
  const Cloud::Ptr cloud(new Cloud);
  const bool ply = std::filesystem::path(file).extension() == ".ply";
  ASSERT_EQ(ply ? pcl::io::loadPLYFile(file, *cloud) : pcl::io::loadPCDFile(file, *cloud), 0) << file;
  ASSERT_FALSE(cloud->empty());

  pcl::FilmstickingPP<pcl::PointXYZ> film;
  film.setInputCloud(cloud);
  const pcl::PolygonMesh mesh = reconstruct(film, 0);
  ASSERT_EQ(film.getStatus(), Status::Ok) << film.getStatusMessage();

  // Closed, manifold, oriented, outward.
  EXPECT_EQ(surface_fault(to_mesh(mesh)), "");
  EXPECT_GT(signed_volume(to_mesh(mesh)), 0);

  // The vertices are the input's points, bit for bit, and nearly all of them.
  const pcl::Indices ids = film.getVertexIndices();
  ASSERT_EQ(ids.size(), mesh.cloud.width);
  EXPECT_TRUE(std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<int>()) == ids.end());
  for (std::size_t k = 0; k < ids.size(); ++k)
    ASSERT_EQ(
        std::memcmp(&mesh.cloud.data[k * mesh.cloud.point_step], &(*cloud)[ids[k]].x, 3 * sizeof(float)), 0)
        << k;
  const Report report = film.getReport();
  EXPECT_EQ(report.sites + report.duplicates + report.non_finite, static_cast<std::int64_t>(cloud->size()));
  EXPECT_GT(static_cast<double>(ids.size()), 0.9 * static_cast<double>(report.sites));

  // The same again, in a used object and in one thread.
  const pcl::PolygonMesh again = reconstruct(film, 1);
  EXPECT_EQ(film.getVertexIndices(), ids);
  EXPECT_EQ(again.cloud.data, mesh.cloud.data);
  ASSERT_EQ(again.polygons.size(), mesh.polygons.size());
  for (std::size_t t = 0; t < mesh.polygons.size(); ++t)
    ASSERT_EQ(again.polygons[t].vertices, mesh.polygons[t].vertices) << t;
}

INSTANTIATE_TEST_SUITE_P(Files, Dataset, ::testing::ValuesIn(files));

}  // namespace
}  // namespace filmsticking::test

int main(int argc, char** argv) {
  // Before InitGoogleTest, which asks for the parameters.
  for (int k = 1; k < argc; ++k)
    if (std::strncmp(argv[k], "--gtest", 7) != 0) filmsticking::test::files.emplace_back(argv[k]);
  if (filmsticking::test::files.empty()) filmsticking::test::files.emplace_back();
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
