// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_chain.h"

#include <cmath>

#include "io/cloud.h"
#include "io/io_error.h"
#include "io/no_return.h"
#include "steps.h"

namespace filmsticking::filters {
namespace {

/// Finite, and small enough for PCL's single precision, in which squares are taken.
bool is_usable(const Point& p) {
  return std::abs(p[0]) < 1e30 && std::abs(p[1]) < 1e30 && std::abs(p[2]) < 1e30;
}

bool is_in(const Box& box, const Point& p) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(box.least[axis] <= p[axis] && p[axis] <= box.most[axis])) return false;
  return true;
}

pcl::PCLPointCloud2 usable_points(const pcl::PCLPointCloud2& cloud, const std::optional<Box>& box) {
  const std::vector<Point> points = io::positions_of(cloud);
  const std::vector<bool> far = io::absurdly_far(points);
  std::vector<int> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!far[i] && is_usable(points[i]) && (!box || is_in(*box, points[i])))
      kept.push_back(static_cast<int>(i));
  return io::select(cloud, kept);
}

/// The point that positions count from, so that single precision suffices. The origin where it does already:
/// the cells of a grid are then PCL's.
Point origin_of(const pcl::PCLPointCloud2& cloud) {
  if (io::size_of(cloud) == 0 || io::float_exact(cloud)) return {0, 0, 0};
  return io::PositionFields(cloud).load(io::bytes_of(cloud, 0));
}

/// The cloud with x, y, z as FLOAT32, counted from the origin. The bytes of its points are as long as before.
pcl::PCLPointCloud2 to_single(pcl::PCLPointCloud2 cloud, const Point& origin) {
  const io::PositionFields doubles(cloud);
  if (doubles.single()) return cloud;
  for (pcl::PCLPointField& field : cloud.fields)
    if (field.name == "x" || field.name == "y" || field.name == "z")
      field.datatype = pcl::PCLPointField::FLOAT32;
  const io::PositionFields singles(cloud);
  for (std::size_t i = 0; i < cloud.width; ++i) {
    std::uint8_t* point = cloud.data.data() + i * cloud.point_step;
    const Point p = doubles.load(point);
    singles.store({p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]}, point);
  }
  return cloud;
}

/// The inverse of to_single(), with the positions as they are now.
pcl::PCLPointCloud2 to_double(const pcl::PCLPointCloud2& cloud, const Point& origin) {
  std::vector<Point> positions = io::positions_of(cloud);
  for (Point& p : positions) p = {origin[0] + p[0], origin[1] + p[1], origin[2] + p[2]};
  return io::with_positions(cloud, positions);
}

pcl::PCLPointCloud2 run(const pcl::PCLPointCloud2& cloud, const FilterOptions& options) {
  pcl::PCLPointCloud2 kept = usable_points(cloud, options.crop);
  const bool single = io::PositionFields(kept).single();
  const Point origin = origin_of(kept);
  // Outliers go before the voxels: a lone point would get a voxel of its own, as heavy as any.
  if (options.outliers) kept = io::select(kept, inliers(to_single(kept, origin), *options.outliers));
  if (!options.voxel && !options.smoothing) return kept;
  kept = to_single(std::move(kept), origin);
  if (options.voxel) kept = one_point_a_voxel(kept, *options.voxel);
  if (options.smoothing) kept = smoothed(kept, *options.smoothing);
  return single ? kept : to_double(kept, origin);
}

}  // namespace

pcl::PCLPointCloud2 filter(const pcl::PCLPointCloud2& cloud, const FilterOptions& options) {
  check(options);
  if (!options.any()) return cloud;
  if (cloud.is_bigendian) throw FilterError("the cloud's numbers are big-endian");
  try {
    return run(cloud, options);
  } catch (const io::IoError& error) {
    throw FilterError(error.what());
  }
}

}  // namespace filmsticking::filters
