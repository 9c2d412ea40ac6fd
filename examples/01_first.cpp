// SPDX-License-Identifier: GPL-3.0-or-later
// The shortest program: a cloud without normals in, a closed mesh out. README.md quotes it.
#include <pcl/io/auto_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>
#include <pcl/surface/filmsticking_pp.h>

#include <cstdio>
#include <exception>

namespace {

using PointT = pcl::PointXYZ;

int run(const char* scan, const char* result) {
  pcl::PointCloud<PointT>::Ptr cloud(new pcl::PointCloud<PointT>);
  if (pcl::io::load(scan, *cloud) != 0) return 1;

  pcl::FilmstickingPP<PointT> filmsticking;
  filmsticking.setInputCloud(cloud);
  pcl::PolygonMesh mesh;
  filmsticking.reconstruct(mesh);
  if (filmsticking.getStatus() != pcl::FilmstickingPP<PointT>::Status::Ok) return 1;  // PCL_ERROR says why

  std::printf("%zu points, %zu triangles\n", cloud->size(), mesh.polygons.size());
  return pcl::io::savePLYFileBinary(result, mesh) == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s SCAN.(pcd|ply|obj) MESH.ply\n", argv[0]);
    return 2;
  }
  try {
    return run(argv[1], argv[2]);
  } catch (const std::exception& error) {  // PCL throws on some files
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 1;
  }
}
