// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "pose_source.h"

namespace filmsticking::stream {

PoseSource trajectory_poses(Trajectory trajectory) {
  return [trajectory = std::move(trajectory), count = std::size_t{0}](
             const Frame& frame, const std::vector<Point>&) mutable -> Placement {
    const std::size_t n = count++;
    if (frame.time) {
      if (const auto pose = trajectory.at(*frame.time)) return {pose, ""};
      return {std::nullopt, "the trajectory has no pose for its time"};
    }
    if (n < trajectory.size()) return {trajectory[n], ""};
    return {std::nullopt, "the trajectory has only " + std::to_string(trajectory.size()) + " poses"};
  };
}

PoseSource sensor_poses() {
  return [](const Frame& frame, const std::vector<Point>&) -> Placement {
    return {frame.sensor_pose, "", !frame.sensor_pose.isApprox(Pose::Identity(), 1e-9)};
  };
}

PoseSource sensor_poses_or(PoseSource fallback) {
  return [fallback = std::move(fallback)](const Frame& frame, const std::vector<Point>& points) -> Placement {
    if (!frame.sensor_pose.isApprox(Pose::Identity(), 1e-9)) return {frame.sensor_pose, ""};
    return fallback(frame, points);
  };
}

}  // namespace filmsticking::stream
