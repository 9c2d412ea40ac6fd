// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "frame.h"
#include "io/model.h"
#include "trajectory.h"

namespace filmsticking::capture {

/// Where a frame belongs, or why it is left out.
struct Placement {
  std::optional<Pose> pose;
  std::string reason;  ///< a clause; empty with a pose
};

/// Finds the pose of each frame, in the order in which they come.
class PoseSource {
 public:
  virtual ~PoseSource() = default;

  /// `points`: those of the frame that the filters left, in the sensor's coordinates.
  virtual Placement place(const Frame& frame, const io::Model& points) = 0;
};

/// Poses of a trajectory: by the frame's time; the n-th for the n-th frame if that has none.
std::unique_ptr<PoseSource> trajectory_poses(Trajectory trajectory);

/// The poses that come with the clouds.
std::unique_ptr<PoseSource> sensor_poses();

/// How a frame is fitted to those before it.
enum class Fit {
  Icp,   ///< point to point
  Gicp,  ///< plane to plane
};

struct RegistrationOptions {
  Fit fit = Fit::Gicp;
  /// Least share of a frame's points that must lie on those before it. A turntable's step of 30 degrees
  /// leaves about a half; what does not fit comes to a quarter by chance.
  double min_overlap = 0.35;
};

/// Fits each frame to all before it that were placed, by PCL; the first has the identity. A fit that brings
/// too little of the frame onto the model is refused.
std::unique_ptr<PoseSource> registered_poses(const RegistrationOptions& options);

/// The pose that comes with a cloud where it is another than the identity; else that of `fallback`, which
/// sees those frames only.
std::unique_ptr<PoseSource> sensor_poses_or(std::unique_ptr<PoseSource> fallback);

}  // namespace filmsticking::capture
