// SPDX-License-Identifier: GPL-3.0-or-later
// The same cloud through the surface classes of PCL and through pcl::FilmstickingPP, one PLY file each.
// The numbers of the comparison in apps/README.md come from here and from mesh_report.
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
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using PointT = pcl::PointNormal;
using Cloud = pcl::PointCloud<PointT>;
using Tree = pcl::search::KdTree<PointT>;

/// The mean distance to the nearest other point: what the radii of the other classes are taken from.
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

/// Normals as PCL's tutorial on Poisson makes them: away from the middle.
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

int run(const std::string& file, const std::string& folder) {
  const Cloud::Ptr cloud(new Cloud);
  if (pcl::io::load(file, *cloud) != 0 || cloud->size() < 13) {
    std::fprintf(stderr, "surfaces: cannot read enough points from %s\n", file.c_str());
    return 1;
  }
  const double step = spacing(cloud);
  add_normals(cloud);

  const auto mesh_by = [&](pcl::PCLSurfaceBase<PointT>& method) {
    method.setInputCloud(cloud);
    method.setSearchMethod(Tree::Ptr(new Tree));
    pcl::PolygonMesh mesh;
    method.reconstruct(mesh);
    return mesh;
  };
  const std::vector<std::pair<std::string, std::function<pcl::PolygonMesh()>>> methods = {
      {"GreedyProjectionTriangulation",
       [&] {
         pcl::GreedyProjectionTriangulation<PointT> method;
         method.setSearchRadius(6 * step);
         method.setMu(2.5);
         method.setMaximumNearestNeighbors(100);
         return mesh_by(method);
       }},
      {"Poisson",
       [&] {
         pcl::Poisson<PointT> method;
         return mesh_by(method);
       }},
      {"MarchingCubesHoppe",
       [&] {
         pcl::MarchingCubesHoppe<PointT> method;
         method.setGridResolution(60, 60, 60);
         method.setPercentageExtendGrid(0.1f);
         return mesh_by(method);
       }},
      {"ConvexHull",
       [&] {
         pcl::ConvexHull<PointT> method;
         method.setDimension(3);
         return mesh_by(method);
       }},
      {"ConcaveHull",
       [&] {
         pcl::ConcaveHull<PointT> method;
         method.setDimension(3);
         method.setAlpha(3 * step);
         return mesh_by(method);
       }},
      {"FilmstickingPP",
       [&] {
         pcl::FilmstickingPP<PointT> method;
         return mesh_by(method);
       }},
  };
  for (const auto& [name, make_mesh] : methods) {
    const auto start = std::chrono::steady_clock::now();
    const pcl::PolygonMesh mesh = make_mesh();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const std::string path = std::string(folder).append("/").append(name).append(".ply");
    if (mesh.polygons.empty() || pcl::io::savePLYFileBinary(path, mesh) != 0) {
      std::fprintf(stderr, "surfaces: %s made no mesh, or it cannot be written to %s\n", name.c_str(),
                   folder.c_str());
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
