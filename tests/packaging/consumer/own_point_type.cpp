// SPDX-License-Identifier: GPL-3.0-or-later
#define PCL_NO_PRECOMPILE
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>
#include <pcl/surface/filmsticking_pp.h>

#include <cstdio>

struct Hit {
  PCL_ADD_POINT4D;
  std::uint16_t ring = 0;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};
POINT_CLOUD_REGISTER_POINT_STRUCT(Hit, (float, x, x)(float, y, y)(float, z, z)(std::uint16_t, ring, ring))

int main() {
  pcl::PointCloud<Hit>::Ptr cloud(new pcl::PointCloud<Hit>);
  for (int i = 0; i < 8; ++i) {  // a cube
    Hit hit;
    hit.x = static_cast<float>(i & 1);
    hit.y = static_cast<float>(i >> 1 & 1);
    hit.z = static_cast<float>(i >> 2);
    hit.ring = static_cast<std::uint16_t>(100 + i);
    cloud->push_back(hit);
  }
  pcl::FilmstickingPP<Hit> film;
  film.setInputCloud(cloud);
  pcl::PointCloud<Hit> points;
  std::vector<pcl::Vertices> polygons;
  film.reconstruct(points, polygons);
  std::printf("%zu triangles\n", polygons.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k].ring != 100 + film.getVertexIndices()[k]) return 1;
  return polygons.size() == 12 ? 0 : 1;
}
