// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "io/cloud.h"
#include "steps.h"

namespace filmsticking::filters {
namespace {

bool is_colour(const pcl::PCLPointField& field) {
  return (field.name == "rgb" || field.name == "rgba") &&
         (field.datatype == pcl::PCLPointField::FLOAT32 || field.datatype == pcl::PCLPointField::UINT32);
}

/// PCL takes every field for one float or a colour, so others must not reach it.
bool has_mean(const pcl::PCLPointField& field) {
  return field.count <= 1 && (field.datatype == pcl::PCLPointField::FLOAT32 || is_colour(field));
}

/// The cloud with the fields that have a mean only.
pcl::PCLPointCloud2 fields_with_mean(const pcl::PCLPointCloud2& cloud) {
  pcl::PCLPointCloud2 lean;
  lean.header = cloud.header;
  lean.is_bigendian = cloud.is_bigendian;
  lean.is_dense = cloud.is_dense;
  lean.height = 1;
  lean.width = cloud.width;
  std::vector<std::size_t> sources;
  for (const pcl::PCLPointField& field : cloud.fields) {
    if (!has_mean(field) || std::size_t{field.offset} + sizeof(float) > cloud.point_step) continue;
    sources.push_back(field.offset);
    lean.fields.push_back(field);
    lean.fields.back().count = 1;
    lean.fields.back().offset = lean.point_step;
    lean.point_step += sizeof(float);
  }
  lean.row_step = lean.point_step * lean.width;
  lean.data.resize(lean.row_step);
  std::uint8_t* to = lean.data.data();
  for (std::size_t i = 0; i < cloud.width; ++i)
    for (const std::size_t source : sources) {
      std::memcpy(to, cloud.data.data() + i * cloud.point_step + source, sizeof(float));
      to += sizeof(float);
    }
  return lean;
}

/// PCL numbers the cells by an int, each axis too, and does nothing where they do not suffice.
void check_cells(const pcl::PCLPointCloud2& cloud, double leaf) {
  constexpr double kMost = std::numeric_limits<int>::max() - 64.0;
  const io::PositionFields fields(cloud);
  std::array<double, 3> least, most;
  least.fill(std::numeric_limits<double>::infinity());
  most.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < cloud.width; ++i) {
    const Point p = fields.load(cloud.data.data() + i * cloud.point_step);
    for (int axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], p[axis]);
      most[axis] = std::max(most[axis], p[axis]);
    }
  }
  double cells = 1;
  for (int axis = 0; axis < 3; ++axis) {
    cells *= (most[axis] - least[axis]) / leaf + 2;  // one more for each border that rounding may move
    if (std::max(std::abs(least[axis]), std::abs(most[axis])) / leaf > kMost) cells = kMost + 1;
  }
  if (!(cells <= kMost))
    throw FilterError("the voxels are too small for this cloud: there would be too many");
}

/// Each mean with the sensor of the point nearest to it: a mean of sensors would stand between them.
pcl::PCLPointCloud2 with_sensors(pcl::PCLPointCloud2 means, const pcl::PCLPointCloud2& cloud) {
  const std::vector<Point> sensors = io::viewpoints_of(cloud);
  if (sensors.empty()) return means;
  const auto to_pcl = [](const pcl::PCLPointCloud2& from) {
    pcl::PointCloud<pcl::PointXYZ>::Ptr points(new pcl::PointCloud<pcl::PointXYZ>);
    for (const Point& p : io::positions_of(from))
      points->push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
    return points;
  };
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud(to_pcl(cloud));
  std::vector<Point> nearest;
  pcl::Indices found(1);
  std::vector<float> distances(1);
  const auto places = to_pcl(means);
  for (const pcl::PointXYZ& mean : *places) {
    tree.nearestKSearch(mean, 1, found, distances);
    nearest.push_back(sensors[static_cast<std::size_t>(found[0])]);
  }
  means.fields.erase(
      std::remove_if(means.fields.begin(), means.fields.end(),
                     [](const pcl::PCLPointField& field) { return io::is_viewpoint(field.name); }),
      means.fields.end());
  return io::with_stations(means, nearest);
}

}  // namespace

pcl::PCLPointCloud2 one_point_a_voxel(const pcl::PCLPointCloud2& cloud, double leaf) {
  const auto lean = std::make_shared<pcl::PCLPointCloud2>(fields_with_mean(cloud));
  if (cloud.width == 0) return *lean;
  check_cells(*lean, leaf);
  pcl::VoxelGrid<pcl::PCLPointCloud2> filter;
  filter.setInputCloud(lean);
  const auto size = static_cast<float>(leaf);
  filter.setLeafSize(size, size, size);
  pcl::PCLPointCloud2 means;
  filter.filter(means);
  return with_sensors(std::move(means), cloud);
}

}  // namespace filmsticking::filters
