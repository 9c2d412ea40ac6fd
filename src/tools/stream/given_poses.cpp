// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_source.h"

namespace filmsticking::capture {
namespace {

class TrajectoryPoses : public PoseSource {
 public:
  explicit TrajectoryPoses(Trajectory trajectory) : trajectory_(std::move(trajectory)) {}

  Placement place(const Frame& frame, const io::Model&) override {
    const std::size_t n = count_++;
    if (!frame.time) {
      if (n < trajectory_.size()) return {trajectory_[n], ""};
      return {std::nullopt, "the trajectory has " + std::to_string(trajectory_.size()) + " poses only"};
    }
    if (const auto pose = trajectory_.at(*frame.time)) return {pose, ""};
    return {std::nullopt, "the trajectory has no pose for its time"};
  }

 private:
  Trajectory trajectory_;
  std::size_t count_ = 0;
};

class SensorPoses : public PoseSource {
 public:
  Placement place(const Frame& frame, const io::Model&) override { return {frame.sensor_pose, ""}; }
};

class SensorPosesOr : public PoseSource {
 public:
  explicit SensorPosesOr(std::unique_ptr<PoseSource> fallback) : fallback_(std::move(fallback)) {}

  Placement place(const Frame& frame, const io::Model& points) override {
    if (!frame.sensor_pose.isApprox(Pose::Identity(), 1e-9)) return {frame.sensor_pose, ""};
    return fallback_->place(frame, points);
  }

 private:
  std::unique_ptr<PoseSource> fallback_;
};

}  // namespace

std::unique_ptr<PoseSource> trajectory_poses(Trajectory trajectory) {
  return std::make_unique<TrajectoryPoses>(std::move(trajectory));
}

std::unique_ptr<PoseSource> sensor_poses() { return std::make_unique<SensorPoses>(); }

std::unique_ptr<PoseSource> sensor_poses_or(std::unique_ptr<PoseSource> fallback) {
  return std::make_unique<SensorPosesOr>(std::move(fallback));
}

}  // namespace filmsticking::capture
