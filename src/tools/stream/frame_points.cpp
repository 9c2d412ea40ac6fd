// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame_points.h"

#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <cmath>

#include "capture_error.h"
#include "filters/filter_chain.h"
#include "filters/position_fields.h"

namespace filmsticking::capture {
namespace {

const pcl::PCLPointField* colour_field(const pcl::PCLPointCloud2& cloud) {
  for (const pcl::PCLPointField& field : cloud.fields)
    if ((field.name == "rgb" || field.name == "rgba") && std::size_t{field.offset} + 4 <= cloud.point_step)
      return &field;
  return nullptr;
}

}  // namespace

io::Model frame_points(const Frame& frame, const filters::FilterOptions& filters) {
  io::Model points;
  try {
    filters::FilterOptions chosen = filters;
    if (!chosen.any()) {  // a box around everything leaves out what is not finite
      constexpr double kFar = 1e30;
      chosen.crop = filters::Box{{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}};
    }
    const pcl::PCLPointCloud2 cloud = filters::filter(frame.cloud, chosen);
    const filters::PositionFields fields(cloud);
    const pcl::PCLPointField* colour = colour_field(cloud);
    for (std::size_t i = 0; i < cloud.width; ++i) {
      const std::uint8_t* point = cloud.data.data() + i * cloud.point_step;
      const std::array<float, 3> p = fields.load(point);
      points.positions.push_back({p[0], p[1], p[2]});
      if (colour != nullptr)  // blue, green, red, alpha
        points.colours.push_back(
            {point[colour->offset + 2], point[colour->offset + 1], point[colour->offset]});
    }
  } catch (const filters::FilterError& error) {
    throw CaptureError(error.what());
  }
  if (points.positions.empty()) throw CaptureError("no point is left of it");
  return points;
}

io::Model moved(io::Model points, const Pose& pose) {
  for (Point& p : points.positions) {
    const Eigen::Vector3d to = pose * Eigen::Vector3d(p[0], p[1], p[2]);
    p = {to.x(), to.y(), to.z()};
  }
  return points;
}

double mean_spacing(const io::Model& points) {
  constexpr std::size_t kSample = 1000;
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  if (points.positions.size() < 2) return 0;
  const Point& origin = points.positions[0];  // single precision would not do for large coordinates
  for (const Point& p : points.positions)
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

}  // namespace filmsticking::capture
