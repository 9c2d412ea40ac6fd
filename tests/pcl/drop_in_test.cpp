// SPDX-License-Identifier: GPL-3.0-or-later
// A program that meshes through pcl::PCLSurfaceBase: only the constructor changes.
#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/memory.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/filmsticking_pp.h>
#include <pcl/surface/gp3.h>
#include <pcl/surface/poisson.h>

#include "clouds.h"
#include "mesh.h"
#include "support/surface_check.h"

#ifdef __SANITIZE_ADDRESS__
extern "C" const char* __lsan_default_suppressions();
const char* __lsan_default_suppressions() { return "leak:pcl::poisson\n"; }  // PCL's own leak
#endif

namespace filmsticking::test {
namespace {

using pcl::PointNormal;
using Base = pcl::PCLSurfaceBase<PointNormal>;

/// The program, which knows nothing of the method.
pcl::PolygonMesh make_mesh(const Base::Ptr& method, const pcl::PointCloud<PointNormal>::ConstPtr& cloud) {
  method->setSearchMethod(pcl::search::KdTree<PointNormal>::Ptr(new pcl::search::KdTree<PointNormal>));
  method->setInputCloud(cloud);
  pcl::PolygonMesh mesh;
  method->reconstruct(mesh);
  return mesh;
}

TEST(DropIn, OnlyTheConstructorChanges) {
  pcl::PointCloud<PointNormal>::Ptr cloud(new pcl::PointCloud<PointNormal>);
  ASSERT_EQ(pcl::io::loadPCDFile(TEST_DATA "/bun0.pcd", *cloud), 0);

  const pcl::GreedyProjectionTriangulation<PointNormal>::Ptr gp3(
      new pcl::GreedyProjectionTriangulation<PointNormal>);
  gp3->setSearchRadius(0.025);  // none of these has a default
  gp3->setMu(2.5);
  gp3->setMaximumNearestNeighbors(100);
  // make_shared for Poisson: PCL's library deletes it otherwise than a program of C++17 allocates it.
  const Base::Ptr methods[] = {gp3, pcl::make_shared<pcl::Poisson<PointNormal>>(),
                               Base::Ptr(new pcl::FilmstickingPP<PointNormal>)};
  for (const Base::Ptr& method : methods) EXPECT_FALSE(make_mesh(method, cloud).polygons.empty());

  const Mesh mesh = to_mesh(make_mesh(methods[2], cloud));
  EXPECT_EQ(surface_fault(mesh), "");
  EXPECT_GT(signed_volume(mesh), 0);
}

TEST(DropIn, NormalsAreNotNeeded) {
  const Mesh mesh =
      to_mesh(make_mesh(Base::Ptr(new pcl::FilmstickingPP<PointNormal>), make_sphere<PointNormal>(300)));
  EXPECT_EQ(surface_fault(mesh), "");
  EXPECT_EQ(mesh.positions.size(), 300u);
}

}  // namespace
}  // namespace filmsticking::test
