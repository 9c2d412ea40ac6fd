// SPDX-License-Identifier: GPL-3.0-or-later
// A chain of PCL around pcl::FilmstickingPP: load, remove outliers, thin, mesh, smooth, save.
// docs/class.md goes through it.
#include <pcl/common/common.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/io/auto_io.h>
#include <pcl/point_types.h>
#include <pcl/surface/filmsticking_pp.h>
#include <pcl/surface/vtk_smoothing/vtk_mesh_smoothing_laplacian.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace {

using PointT = pcl::PointXYZ;

/// The cell width at which about `points` cells cover the surface of the cloud's box.
float leaf_size(const pcl::PointCloud<PointT>& cloud, double points) {
  Eigen::Vector4f low, high;
  pcl::getMinMax3D(cloud, low, high);
  const Eigen::Vector3f size = (high - low).head<3>();
  const double area = 2.0 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
  return static_cast<float>(std::sqrt(area / points));
}

int run(const char* scan, const char* result) {
  pcl::PointCloud<PointT>::Ptr cloud(new pcl::PointCloud<PointT>);
  if (pcl::io::load(scan, *cloud) != 0 || cloud->empty()) {
    std::fprintf(stderr, "chain: cannot read points from %s\n", scan);
    return 1;
  }
  const float leaf = leaf_size(*cloud, 5000);

  // A mesh through all points would go through the outliers, too.
  pcl::StatisticalOutlierRemoval<PointT> cleaner;
  cleaner.setInputCloud(cloud);
  cleaner.setMeanK(16);
  cleaner.setStddevMulThresh(3);
  pcl::PointCloud<PointT>::Ptr clean(new pcl::PointCloud<PointT>);
  cleaner.filter(*clean);

  pcl::VoxelGrid<PointT> thinner;
  thinner.setInputCloud(clean);
  thinner.setLeafSize(leaf, leaf, leaf);
  pcl::PointCloud<PointT>::Ptr thin(new pcl::PointCloud<PointT>);
  thinner.filter(*thin);

  pcl::FilmstickingPP<PointT> filmsticking;
  filmsticking.setInputCloud(thin);
  pcl::PolygonMesh::Ptr mesh(new pcl::PolygonMesh);
  filmsticking.reconstruct(*mesh);
  if (filmsticking.getStatus() != pcl::FilmstickingPP<PointT>::Status::Ok) return 1;  // PCL_ERROR says why

  pcl::MeshSmoothingLaplacianVTK smoother;
  smoother.setInputMesh(mesh);
  smoother.setNumIter(10);
  pcl::PolygonMesh smooth;
  smoother.process(smooth);
  if (pcl::io::save(result, smooth) != 0) {
    std::fprintf(stderr, "chain: cannot write %s\n", result);
    return 1;
  }
  std::printf("%zu points, %zu without outliers, %zu in voxels, %zu triangles\n", cloud->size(),
              clean->size(), thin->size(), smooth.polygons.size());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s SCAN.(pcd|ply|obj) MESH.(ply|obj)\n", argv[0]);
    return 1;
  }
  try {
    return run(argv[1], argv[2]);
  } catch (const std::exception& error) {  // PCL throws on some files
    std::fprintf(stderr, "chain: %s\n", error.what());
    return 1;
  }
}
