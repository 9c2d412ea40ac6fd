// SPDX-License-Identifier: GPL-3.0-or-later
#include "accumulator.h"

#include "frame_points.h"
#include "stream_error.h"

namespace filmsticking::stream {

Accumulator::Accumulator(AccumulatorOptions options, PoseSource poses)
    : options_(options), poses_(std::move(poses)) {}

std::optional<std::string> Accumulator::add(const Frame& frame) {
  try {
    const pcl::PCLPointCloud2 cloud = frame_points(frame, options_.filters);
    const std::vector<Point> points = io::positions_of(cloud);
    const Placement placement = poses_(frame, points);
    if (!placement.pose) throw StreamError(placement.reason);
    if (!fused_) {
      double width = options_.width > 0 ? options_.width : 1.5 * mean_spacing(points);
      if (!(width > 0)) width = 1;  // all points are the same
      fused_.emplace(width, options_.most_points);
    }
    const Eigen::Vector3d at = placement.pose->translation();
    fused_->add(moved(points, *placement.pose), io::colours_of(cloud),
                placement.sensor_known ? std::optional(Point{at.x(), at.y(), at.z()}) : std::nullopt);
    placed_.push_back({frame.name, frame.time, *placement.pose});
    return std::nullopt;
  } catch (const StreamError& error) {
    ++left_out_;
    return error.what();
  }
}

pcl::PCLPointCloud2 Accumulator::cloud(int seen_by) const {
  return fused_ ? fused_->cloud(static_cast<std::uint32_t>(seen_by)) : io::make_cloud({});
}

}  // namespace filmsticking::stream
