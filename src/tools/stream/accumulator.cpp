// SPDX-License-Identifier: GPL-3.0-or-later
#include "accumulator.h"

#include "capture_error.h"
#include "frame_points.h"

namespace filmsticking::capture {

Accumulator::Accumulator(AccumulatorOptions options, std::unique_ptr<PoseSource> poses)
    : options_(options), poses_(std::move(poses)) {}

std::optional<std::string> Accumulator::add(const Frame& frame) {
  try {
    const io::Model points = frame_points(frame, options_.filters);
    const Placement placement = poses_->place(frame, points);
    if (!placement.pose) throw CaptureError(placement.reason);
    if (!map_) {
      double leaf = options_.leaf > 0 ? options_.leaf : 1.5 * mean_spacing(points);
      if (!(leaf > 0)) leaf = 1;  // all points are the same
      map_.emplace(leaf, options_.most_points);
    }
    map_->add(moved(points, *placement.pose));
    placed_.push_back({frame.name, frame.time, *placement.pose});
    return std::nullopt;
  } catch (const CaptureError& error) {
    ++left_out_;
    return error.what();
  }
}

io::Model Accumulator::points(int seen_by) const {
  return map_ ? map_->points(static_cast<std::uint32_t>(seen_by)) : io::Model();
}

}  // namespace filmsticking::capture
