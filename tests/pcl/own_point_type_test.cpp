// SPDX-License-Identifier: GPL-3.0-or-later
// A point type that PCL does not know, with the class compiled from its headers.
#define PCL_NO_PRECOMPILE
#include <gtest/gtest.h>
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>
#include <pcl/surface/filmsticking_pp.h>

#include "clouds.h"

#ifdef __clang__  // what PCL's macro expands to, in every point type
#pragma clang diagnostic ignored "-Wgnu-anonymous-struct"
#pragma clang diagnostic ignored "-Wnested-anon-types"
#endif

struct LabelledHit {
  PCL_ADD_POINT4D;
  int hit = 0;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

POINT_CLOUD_REGISTER_POINT_STRUCT(LabelledHit, (float, x, x)(float, y, y)(float, z, z)(int, hit, hit))

namespace filmsticking::test {
namespace {

TEST(OwnPointType, KeepsItsFields) {
  const auto cloud = make_sphere<LabelledHit>(100);
  for (std::size_t i = 0; i < cloud->size(); ++i) (*cloud)[i].hit = static_cast<int>(1000 + i);
  pcl::FilmstickingPP<LabelledHit> filmsticking;
  filmsticking.setInputCloud(cloud);
  pcl::PointCloud<LabelledHit> points;
  std::vector<pcl::Vertices> polygons;
  filmsticking.reconstruct(points, polygons);
  ASSERT_EQ(points.size(), 100u);
  for (std::size_t k = 0; k < points.size(); ++k)
    EXPECT_EQ(points[k].hit, 1000 + filmsticking.getVertexIndices()[k]);

  pcl::PolygonMesh mesh;
  filmsticking.reconstruct(mesh);
  pcl::PointCloud<LabelledHit> in_mesh;
  pcl::fromPCLPointCloud2(mesh.cloud, in_mesh);
  ASSERT_EQ(in_mesh.size(), 100u);
  for (std::size_t k = 0; k < in_mesh.size(); ++k) EXPECT_EQ(in_mesh[k].hit, points[k].hit);
}

}  // namespace
}  // namespace filmsticking::test
