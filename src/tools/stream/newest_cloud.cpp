// SPDX-License-Identifier: GPL-3.0-or-later
#include "newest_cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>
#include <utility>
#include <vector>

#include "cells.h"
#include "frame_points.h"
#include "io/bytes.h"
#include "io/cloud.h"

namespace filmsticking::stream {
namespace {

using Fields = std::vector<pcl::PCLPointField>;

const pcl::PCLPointField* find_same(const Fields& fields, const pcl::PCLPointField& wanted) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const pcl::PCLPointField& field) {
    return field.name == wanted.name && field.datatype == wanted.datatype && field.count == wanted.count;
  });
  return found == fields.end() ? nullptr : &*found;
}

/// x, y, z in single precision, then the other fields.
Fields fields_to_hold(const Fields& of_frame) {
  Fields fields = io::make_cloud({}).fields;
  for (const pcl::PCLPointField& field : of_frame)
    if (field.name != "x" && field.name != "y" && field.name != "z" && !io::is_viewpoint(field.name))
      fields.push_back(field);
  return fields;
}

/// The points with these fields only, as one row without padding; fields that they lack are zero.
pcl::PCLPointCloud2 with_fields(const pcl::PCLPointCloud2& cloud, Fields fields) {
  struct Copy {
    std::size_t from, to, bytes;
  };
  std::vector<Copy> copies;
  std::size_t step = 0;
  for (pcl::PCLPointField& field : fields) {
    const std::size_t bytes = io::size_of(io::Scalar{field.datatype}) * std::max<std::size_t>(1, field.count);
    if (const pcl::PCLPointField* source = find_same(cloud.fields, field))
      copies.push_back({source->offset, step, bytes});
    field.offset = static_cast<std::uint32_t>(step);
    step += bytes;
  }
  pcl::PCLPointCloud2 packed = io::make_rows(std::move(fields), step, io::size_of(cloud));
  std::uint8_t* to = packed.data.data();
  for (std::size_t i = 0; i < packed.width; ++i, to += step) {
    const std::uint8_t* from = io::bytes_of(cloud, i);
    for (const Copy& copy : copies) std::copy_n(from + copy.from, copy.bytes, to + copy.to);
  }
  return packed;
}

/// Where each point of a frame was seen from, in the world's coordinates.
std::vector<Point> sensors_of(const Frame& frame) {
  std::vector<Point> own = io::viewpoints_of(frame.cloud);
  if (!own.empty()) return moved(std::move(own), frame.sensor_pose);
  const Eigen::Vector3d at = frame.sensor_pose.translation();
  return std::vector<Point>(io::size_of(frame.cloud), Point{at.x(), at.y(), at.z()});
}

bool is_float(double x) { return std::abs(x) <= double{std::numeric_limits<float>::max()}; }

}  // namespace

void NewestCloud::set_bounds(const Bounds& bounds) {
  bounds_ = bounds;
  drop_overtaken(0);
  forget();
}

void NewestCloud::add(const Frame& frame) {
  const std::vector<Point> points = moved(io::positions_of(frame.cloud), frame.sensor_pose);
  pcl::PCLPointCloud2 rows =
      io::with_stations(with_fields(frame.cloud, fields_to_hold(frame.cloud.fields)), sensors_of(frame));
  const io::PositionFields positions(rows);
  const auto store = [&](std::size_t i) {
    if (!std::all_of(points[i].begin(), points[i].end(), is_float)) return false;
    positions.store(points[i], rows.data.data() + i * rows.point_step);
    return true;
  };
  frames_.push_back({++frame_, points_where(rows, store)});
  drop_overtaken(frames_.size() - 1);
  forget();
}

void NewestCloud::clear() { frames_.clear(); }

pcl::PCLPointCloud2 NewestCloud::cloud() const {
  Fields fields = frames_.empty() ? fields_to_hold({}) : frames_.front().points.fields;
  const auto is_missing = [this](const pcl::PCLPointField& field) {
    return std::any_of(frames_.begin(), frames_.end(),
                       [&](const Held& held) { return !find_same(held.points.fields, field); });
  };
  fields.erase(std::remove_if(fields.begin(), fields.end(), is_missing), fields.end());
  pcl::PCLPointCloud2 cloud = with_fields(io::make_cloud({}), fields);
  cloud.data.reserve(size() * cloud.point_step);
  for (const Held& held : frames_) {
    const pcl::PCLPointCloud2 points = with_fields(held.points, fields);
    cloud.data.insert(cloud.data.end(), points.data.begin(), points.data.end());
    cloud.width += points.width;
  }
  cloud.row_step = cloud.width * cloud.point_step;
  return cloud;
}

std::size_t NewestCloud::size() const {
  std::size_t size = 0;
  for (const Held& held : frames_) size += held.points.width;
  return size;
}

/// Drops points in cells that a newer frame, or an earlier point of their own frame, has hit. Frames before
/// `first_changed` have one point a cell already.
void NewestCloud::drop_overtaken(std::size_t first_changed) {
  if (!(bounds_.voxel > 0)) return;
  std::unordered_set<Cell, CellHash> hit;
  for (std::size_t k = frames_.size(); k-- > 0;) {
    pcl::PCLPointCloud2& points = frames_[k].points;
    const io::PositionFields positions(points);
    points = points_where(points, [&](std::size_t i) {
      const Cell cell = cell_of(positions.load(io::bytes_of(points, i)), bounds_.voxel);
      return k >= first_changed ? hit.insert(cell).second : hit.count(cell) == 0;
    });
  }
}

void NewestCloud::forget() {
  const std::int64_t oldest = bounds_.window > 0 ? frame_ - bounds_.window + 1 : 0;
  frames_.erase(
      std::remove_if(frames_.begin(), frames_.end(),
                     [oldest](const Held& held) { return held.number < oldest || held.points.width == 0; }),
      frames_.end());
  if (frames_.empty()) return clear();
  while (frames_.size() > 1 && size() > bounds_.max_points) {
    given_up_ += frames_.front().points.width;
    frames_.pop_front();
  }
  // Never the newest: if it is too large by itself, it is thinned evenly.
  pcl::PCLPointCloud2& newest = frames_.back().points;
  const std::size_t most = bounds_.max_points, all = newest.width;
  if (size() <= most) return;
  given_up_ += static_cast<std::int64_t>(all - most);
  newest = points_where(newest, [&](std::size_t i) { return (i + 1) * most / all > i * most / all; });
}

}  // namespace filmsticking::stream
