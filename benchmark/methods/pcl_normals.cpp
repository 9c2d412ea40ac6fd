// SPDX-License-Identifier: GPL-3.0-or-later
#include "pcl_normals.h"

#include <pcl/common/centroid.h>
#include <pcl/features/normal_3d.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

namespace filmsticking::bench {

std::vector<Point> pcl_normals(const std::vector<Point>& points) {
  constexpr int kNeighbours = 18;  // as CGAL's
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const Point& p : points)
    cloud->push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  Eigen::Vector4f centroid;
  pcl::compute3DCentroid(*cloud, centroid);

  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(pcl::search::KdTree<pcl::PointXYZ>::Ptr(new pcl::search::KdTree<pcl::PointXYZ>));
  estimation.setKSearch(kNeighbours);
  estimation.setViewPoint(centroid[0], centroid[1], centroid[2]);
  pcl::PointCloud<pcl::Normal> towards;
  estimation.compute(towards);
  std::vector<Point> normals;
  for (const pcl::Normal& n : towards) normals.push_back({-n.normal_x, -n.normal_y, -n.normal_z});
  return normals;
}

}  // namespace filmsticking::bench
