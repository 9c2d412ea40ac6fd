// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <pcl/surface/filmsticking_pp.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "clouds.h"
#include "support/surface_check.h"

namespace filmsticking::test {

using pcl::PointNormal;
using pcl::PointXYZ;
using Class = pcl::FilmstickingPP<PointXYZ>;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

template <typename PointT>
struct Surface {
  pcl::PointCloud<PointT> points;
  std::vector<pcl::Vertices> polygons;
};

template <typename PointT>
Surface<PointT> run(pcl::FilmstickingPP<PointT>& filmsticking) {
  Surface<PointT> surface;
  filmsticking.reconstruct(surface.points, surface.polygons);
  return surface;
}

template <typename PointT>
Mesh to_mesh(const Surface<PointT>& surface) {
  Mesh mesh;
  for (const PointT& p : surface.points) mesh.positions.push_back({p.x, p.y, p.z});
  for (const pcl::Vertices& polygon : surface.polygons) {
    EXPECT_EQ(polygon.vertices.size(), 3u);
    mesh.triangles.push_back({polygon.vertices[0], polygon.vertices[1], polygon.vertices[2]});
  }
  return mesh;
}

inline std::vector<pcl::Indices> corners(const std::vector<pcl::Vertices>& polygons) {
  std::vector<pcl::Indices> all;
  for (const pcl::Vertices& polygon : polygons) all.push_back(polygon.vertices);
  return all;
}

inline pcl::PointCloud<PointNormal>::Ptr load_bunny() {
  pcl::PointCloud<PointNormal>::Ptr cloud(new pcl::PointCloud<PointNormal>);
  EXPECT_EQ(pcl::io::loadPCDFile(TEST_DATA "/bun0.pcd", *cloud), 0);
  return cloud;
}

template <typename PointT>
bool same_coordinates(const PointT& a, const PointT& b) {
  return std::memcmp(&a.x, &b.x, 3 * sizeof(float)) == 0;
}

inline void expect_good_surface(const Mesh& mesh) {
  EXPECT_EQ(surface_fault(mesh), "");
  EXPECT_GT(signed_volume(mesh), 0);
}

/// Expects an empty result with `status`, in both overloads, over outputs that were full before.
inline void expect_failure(Class& filmsticking, Status status) {
  Surface<PointXYZ> surface;
  surface.points = *make_sphere<PointXYZ>(10);
  surface.polygons.resize(7);
  ::testing::internal::CaptureStderr();
  EXPECT_NO_THROW(filmsticking.reconstruct(surface.points, surface.polygons));
  const std::string errors = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
  EXPECT_EQ(filmsticking.getStatus(), status) << filmsticking.getStatusMessage();
  EXPECT_FALSE(filmsticking.getStatusMessage().empty());
  EXPECT_TRUE(surface.points.empty());
  EXPECT_EQ(surface.points.width * surface.points.height, 0u);
  EXPECT_TRUE(surface.polygons.empty());
  EXPECT_TRUE(filmsticking.getVertexIndices().empty());

  pcl::PolygonMesh mesh;
  pcl::toPCLPointCloud2(*make_sphere<PointXYZ>(10), mesh.cloud);
  mesh.polygons.resize(7);
  ::testing::internal::CaptureStderr();
  EXPECT_NO_THROW(filmsticking.reconstruct(mesh));
  ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(filmsticking.getStatus(), status);
  EXPECT_TRUE(mesh.cloud.data.empty());
  EXPECT_EQ(mesh.cloud.width * mesh.cloud.height, 0u);
  EXPECT_TRUE(mesh.polygons.empty());
  const auto input = filmsticking.getInputCloud();
  EXPECT_EQ(mesh.header.frame_id, input ? input->header.frame_id : "");
}

}  // namespace filmsticking::test
