// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/point_types.h>
#include <pcl/surface/filmsticking_pp.h>

#include <cmath>
#include <cstdio>

int main() {
  pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZRGB>);
  for (int i = 0; i < 100; ++i) {
    const double z = 1 - (2.0 * i + 1) / 100, radius = std::sqrt(1 - z * z);
    pcl::PointXYZRGB point(static_cast<std::uint8_t>(i), 0, 0);
    point.x = static_cast<float>(radius * std::cos(2.4 * i));
    point.y = static_cast<float>(radius * std::sin(2.4 * i));
    point.z = static_cast<float>(z);
    cloud->push_back(point);
  }
  const pcl::PCLSurfaceBase<pcl::PointXYZRGB>::Ptr method(new pcl::FilmstickingPP<pcl::PointXYZRGB>);
  method->setInputCloud(cloud);
  pcl::PolygonMesh mesh;
  method->reconstruct(mesh);
  std::printf("%zu triangles\n", mesh.polygons.size());
  // The type is the same on both sides of the library's border.
  const auto* film = dynamic_cast<const pcl::FilmstickingPP<pcl::PointXYZRGB>*>(method.get());
  return film && film->getVertexIndices().size() == 100 && mesh.polygons.size() == 196 ? 0 : 1;
}
