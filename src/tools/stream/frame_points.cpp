// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame_points.h"

#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>

#include "filters/filter_chain.h"
#include "io/cloud.h"
#include "stream_error.h"

namespace filmsticking::stream {

pcl::PCLPointCloud2 frame_points(const Frame& frame, const filters::FilterOptions& filters) {
  filters::FilterOptions chosen = filters;
  if (!chosen.any()) {  // a box around everything leaves out what is not finite
    constexpr double kFar = 1e30;
    chosen.crop = filters::Box{{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}};
  }
  try {
    pcl::PCLPointCloud2 points = filters::filter(frame.cloud, chosen);
    if (points.width == 0) throw StreamError("no point is left of it");
    return points;
  } catch (const filters::FilterError& error) {
    throw StreamError(error.what());
  }
}

pcl::PCLPointCloud2 points_where(const pcl::PCLPointCloud2& cloud,
                                 const std::function<bool(std::size_t)>& keep) {
  std::vector<int> kept;
  for (std::size_t i = 0; i < io::size_of(cloud); ++i)
    if (keep(i)) kept.push_back(static_cast<int>(i));
  return io::select(cloud, kept);
}

pcl::PCLPointCloud2 in_range(const pcl::PCLPointCloud2& cloud, double least, double most) {
  const std::vector<Point> points = io::positions_of(cloud);
  return points_where(cloud, [&](std::size_t i) {
    const double range = Eigen::Vector3d(points[i].data()).norm();
    return !(range < least || (most > 0 && range > most));
  });
}

std::vector<Point> moved(std::vector<Point> points, const Pose& pose) {
  for (Point& p : points) {
    const Eigen::Vector3d to = pose * Eigen::Vector3d(p.data());
    p = {to.x(), to.y(), to.z()};
  }
  return points;
}

double mean_spacing(const std::vector<Point>& points) {
  constexpr std::size_t kSample = 1000;
  if (points.size() < 2) return 0;
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  const Point& origin = points[0];  // the tree has single precision, which large coordinates exceed
  for (const Point& p : points)
    cloud->push_back({static_cast<float>(p[0] - origin[0]), static_cast<float>(p[1] - origin[1]),
                      static_cast<float>(p[2] - origin[2])});
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  const std::size_t stride = std::max<std::size_t>(1, cloud->size() / kSample);
  double sum = 0;
  std::size_t count = 0;
  pcl::Indices neighbours;
  std::vector<float> squares;
  for (std::size_t i = 0; i < cloud->size(); i += stride, ++count)
    if (tree.nearestKSearch((*cloud)[i], 2, neighbours, squares) == 2) sum += std::sqrt(squares[1]);
  return sum / static_cast<double>(count);
}

}  // namespace filmsticking::stream
