// SPDX-License-Identifier: GPL-3.0-or-later
// Every point type of PCL with x, y and z, with something in every field.
#include <gtest/gtest.h>
#include <pcl/common/io.h>
#include <pcl/surface/filmsticking_pp.h>

#include <boost/preprocessor/seq/enum.hpp>
#include <cstring>
#include <pcl/impl/point_types.hpp>

#include "clouds.h"

namespace filmsticking::test {
namespace {

template <typename PointT>
class EveryPointType : public ::testing::Test {};

using PointTypes = ::testing::Types<BOOST_PP_SEQ_ENUM(PCL_XYZ_POINT_TYPES)>;
TYPED_TEST_SUITE(EveryPointType, PointTypes, );

std::size_t bytes_of(const pcl::PCLPointField& field) {
  return static_cast<std::size_t>(pcl::getFieldSize(field.datatype)) * std::max(1u, field.count);
}

/// A sphere whose points differ in every field.
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr make_full_sphere(int count) {
  const auto cloud = make_sphere<PointT>(count);
  for (const pcl::PCLPointField& field : pcl::getFields<PointT>()) {
    if (field.name == "x" || field.name == "y" || field.name == "z") continue;
    for (int i = 0; i < count; ++i)
      for (std::size_t byte = 0; byte < bytes_of(field); ++byte)
        reinterpret_cast<std::uint8_t*>(&(*cloud)[i])[field.offset + byte] =
            static_cast<std::uint8_t>(1 + i + 7 * byte + field.offset);
  }
  return cloud;
}

TYPED_TEST(EveryPointType, KeepsEveryField) {
  const auto cloud = make_full_sphere<TypeParam>(100);
  const auto fields = pcl::getFields<TypeParam>();
  pcl::FilmstickingPP<TypeParam> filmsticking;
  filmsticking.setInputCloud(cloud);
  pcl::PointCloud<TypeParam> points;
  std::vector<pcl::Vertices> polygons;
  filmsticking.reconstruct(points, polygons);
  EXPECT_EQ(polygons.size(), 196u);
  ASSERT_EQ(points.size(), 100u);
  pcl::PolygonMesh mesh;
  filmsticking.reconstruct(mesh);
  ASSERT_EQ(mesh.cloud.width, 100u);
  ASSERT_EQ(mesh.cloud.fields.size(), fields.size());

  for (std::size_t f = 0; f < fields.size(); ++f) {
    const pcl::PCLPointField& field = fields[f];
    const pcl::PCLPointField& in_mesh = mesh.cloud.fields[f];
    EXPECT_EQ(in_mesh.name, field.name);
    EXPECT_EQ(in_mesh.datatype, field.datatype);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const TypeParam& point = (*cloud)[filmsticking.getVertexIndices()[k]];
      const auto* expected = reinterpret_cast<const std::uint8_t*>(&point) + field.offset;
      const auto* kept = reinterpret_cast<const std::uint8_t*>(&points[k]) + field.offset;
      const auto* written = &mesh.cloud.data[k * mesh.cloud.point_step + in_mesh.offset];
      EXPECT_EQ(std::memcmp(kept, expected, bytes_of(field)), 0) << field.name << " of vertex " << k;
      EXPECT_EQ(std::memcmp(written, expected, bytes_of(field)), 0) << field.name << " of vertex " << k;
    }
  }
}

}  // namespace
}  // namespace filmsticking::test
