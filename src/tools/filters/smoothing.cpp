// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/mls.h>

#include <cmath>

#include "io/cloud.h"
#include "steps.h"

namespace filmsticking::filters {

pcl::PCLPointCloud2 smoothed(const pcl::PCLPointCloud2& cloud, double radius) {
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  const io::PositionFields fields(cloud);
  const std::size_t step = cloud.point_step;
  Cloud::Ptr points(new Cloud);
  for (std::size_t i = 0; i < cloud.width; ++i) {
    const Point p = fields.load(cloud.data.data() + i * step);
    points->push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  }
  pcl::PCLPointCloud2 result = cloud;
  result.data.clear();
  if (!points->empty()) {
    pcl::MovingLeastSquares<pcl::PointXYZ, pcl::PointXYZ> filter;
    filter.setInputCloud(points);
    filter.setSearchMethod(pcl::search::KdTree<pcl::PointXYZ>::Ptr(new pcl::search::KdTree<pcl::PointXYZ>));
    filter.setSearchRadius(radius);
    filter.setNumberOfThreads(0);  // all
    Cloud moved;
    filter.process(moved);

    // The threads hand in their points as they get ready; the order of the input is the same in every run.
    std::vector<std::ptrdiff_t> moved_at(points->size(), -1);
    const pcl::Indices& sources = filter.getCorrespondingIndices()->indices;
    for (std::size_t k = 0; k < moved.size(); ++k) moved_at[sources[k]] = static_cast<std::ptrdiff_t>(k);
    for (std::size_t i = 0; i < moved_at.size(); ++i) {
      if (moved_at[i] < 0) continue;
      const pcl::PointXYZ& p = moved[moved_at[i]];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
      const std::uint8_t* point = cloud.data.data() + i * step;
      result.data.insert(result.data.end(), point, point + step);
      fields.store({p.x, p.y, p.z}, result.data.data() + result.data.size() - step);
    }
  }
  result.width = static_cast<std::uint32_t>(result.data.size() / step);
  result.row_step = static_cast<std::uint32_t>(result.data.size());
  return result;
}

}  // namespace filmsticking::filters
