// SPDX-License-Identifier: GPL-3.0-or-later
// One cloud through the surface classes of PCL and through pcl::FilmstickingPP, a PLY file each.
// The table in docs/class.md has the times that it prints, and what mesh_report says of the files.
#include <pcl/common/centroid.h>
#include <pcl/common/io.h>
#include <pcl/features/normal_3d.h>
#include <pcl/io/auto_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/concave_hull.h>
#include <pcl/surface/convex_hull.h>
#include <pcl/surface/filmsticking_pp.h>
#include <pcl/surface/gp3.h>
#include <pcl/surface/marching_cubes_hoppe.h>
#include <pcl/surface/poisson.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using PointT = pcl::PointNormal;
using Cloud = pcl::PointCloud<PointT>;
using Tree = pcl::search::KdTree<PointT>;

/// Mean distance to the nearest other point; PCL's classes get their radii from it.
double spacing(const Cloud::ConstPtr& cloud) {
  Tree tree;
  tree.setInputCloud(cloud);
  double sum = 0;
  pcl::Indices ids(2);
  std::vector<float> squares(2);
  for (const PointT& point : *cloud) {
    tree.nearestKSearch(point, 2, ids, squares);
    sum += std::sqrt(squares[1]);
  }
  return sum / static_cast<double>(cloud->size());
}

/// Normals away from the centroid, as PCL's tutorial on Poisson makes them.
void add_normals(const Cloud::Ptr& cloud) {
  pcl::NormalEstimation<PointT, PointT> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(Tree::Ptr(new Tree));
  estimation.setKSearch(12);
  Eigen::Vector4f middle;
  pcl::compute3DCentroid(*cloud, middle);
  estimation.setViewPoint(middle.x(), middle.y(), middle.z());
  Cloud normals;
  estimation.compute(normals);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    (*cloud)[i].getNormalVector3fMap() = -normals[i].getNormalVector3fMap();
}

struct Method {
  std::string name;
  std::unique_ptr<pcl::PCLSurfaceBase<PointT>> surface;
};

/// Each class with its tutorial's settings, and radii from `step`, the spacing.
std::vector<Method> methods(double step) {
  auto greedy = std::make_unique<pcl::GreedyProjectionTriangulation<PointT>>();
  greedy->setSearchRadius(6 * step);
  greedy->setMu(2.5);
  greedy->setMaximumNearestNeighbors(100);
  auto hoppe = std::make_unique<pcl::MarchingCubesHoppe<PointT>>();
  hoppe->setGridResolution(60, 60, 60);
  hoppe->setPercentageExtendGrid(0.1f);
  auto convex = std::make_unique<pcl::ConvexHull<PointT>>();
  convex->setDimension(3);
  auto concave = std::make_unique<pcl::ConcaveHull<PointT>>();
  concave->setDimension(3);
  concave->setAlpha(3 * step);

  std::vector<Method> all;
  all.push_back({"GreedyProjectionTriangulation", std::move(greedy)});
  all.push_back({"Poisson", std::make_unique<pcl::Poisson<PointT>>()});
  all.push_back({"MarchingCubesHoppe", std::move(hoppe)});
  all.push_back({"ConvexHull", std::move(convex)});
  all.push_back({"ConcaveHull", std::move(concave)});
  all.push_back({"FilmstickingPP", std::make_unique<pcl::FilmstickingPP<PointT>>()});
  return all;
}

int run(const std::string& file, const std::string& folder) {
  const Cloud::Ptr cloud(new Cloud);
  if (pcl::io::load(file, *cloud) != 0 || cloud->size() < 13) {
    std::fprintf(stderr, "surfaces: cannot read enough points from %s\n", file.c_str());
    return 1;
  }
  add_normals(cloud);
  for (const auto& [name, surface] : methods(spacing(cloud))) {
    const auto start = std::chrono::steady_clock::now();
    surface->setInputCloud(cloud);
    surface->setSearchMethod(Tree::Ptr(new Tree));
    pcl::PolygonMesh mesh;
    surface->reconstruct(mesh);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const std::string path = std::string(folder).append("/").append(name).append(".ply");
    if (mesh.polygons.empty() || pcl::io::savePLYFileBinary(path, mesh) != 0) {
      std::fprintf(stderr, "surfaces: no mesh by %s, or no file in %s\n", name.c_str(), folder.c_str());
      return 1;
    }
    std::printf("%-30s %8zu triangles %8.2f s\n", name.c_str(), mesh.polygons.size(), seconds.count());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s CLOUD.(pcd|ply) FOLDER\n", argv[0]);
    return 1;
  }
  try {
    return run(argv[1], argv[2]);
  } catch (const std::exception& error) {  // PCL throws on some files
    std::fprintf(stderr, "surfaces: %s\n", error.what());
    return 1;
  }
}
