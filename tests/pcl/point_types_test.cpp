// SPDX-License-Identifier: GPL-3.0-or-later
// Every point type of PCL with x, y and z.
#include <gtest/gtest.h>
#include <pcl/common/io.h>
#include <pcl/surface/filmsticking_pp.h>

#include <boost/preprocessor/seq/enum.hpp>
#include <cstring>
#include <pcl/impl/point_types.hpp>
#include <tuple>

#include "clouds.h"

namespace filmsticking::test {
namespace {

template <typename PointT>
class EveryPointType : public ::testing::Test {};

using PointTypes = ::testing::Types<BOOST_PP_SEQ_ENUM(PCL_XYZ_POINT_TYPES)>;
TYPED_TEST_SUITE(EveryPointType, PointTypes, );

TYPED_TEST(EveryPointType, MakesASurface) {
  const auto cloud = make_sphere<TypeParam>(100);
  pcl::FilmstickingPP<TypeParam> filmsticking;
  filmsticking.setInputCloud(cloud);
  pcl::PointCloud<TypeParam> points;
  std::vector<pcl::Vertices> polygons;
  filmsticking.reconstruct(points, polygons);
  EXPECT_EQ(polygons.size(), 196u);
  ASSERT_EQ(points.size(), 100u);
  for (std::size_t k = 0; k < points.size(); ++k)
    EXPECT_EQ(std::memcmp(&points[k].x, &(*cloud)[filmsticking.getVertexIndices()[k]].x, 3 * sizeof(float)),
              0);

  pcl::PolygonMesh mesh;
  filmsticking.reconstruct(mesh);
  EXPECT_EQ(mesh.cloud.fields.size(), pcl::getFields<TypeParam>().size());
  EXPECT_EQ(mesh.cloud.width, 100u);
}

}  // namespace
}  // namespace filmsticking::test
