// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "filmsticking/types.h"
#include "frame.h"
#include "trajectory.h"

namespace filmsticking::stream {

/// The pose of a frame, or why there is none.
struct Placement {
  std::optional<Pose> pose;
  std::string reason;        ///< a clause; empty with a pose
  bool sensor_known = true;  ///< with a pose: the sensor stood at its origin; false: the identity, by default
};

/// Finds the pose of each frame, in the order in which the frames come. `points`: the frame's points that
/// passed the filters, in the sensor's coordinates; all finite.
using PoseSource = std::function<Placement(const Frame& frame, const std::vector<Point>& points)>;

/// Poses of a trajectory: by the frame's time, or the n-th for the n-th frame if the frame has no time.
PoseSource trajectory_poses(Trajectory trajectory);

/// The poses that come with the clouds.
PoseSource sensor_poses();

/// The pose that comes with a cloud unless it is the identity; else that of `fallback`, which sees only such
/// frames.
PoseSource sensor_poses_or(PoseSource fallback);

/// How registration fits a frame to those before it.
enum class Fit {
  Icp,   ///< point to point
  Gicp,  ///< plane to plane
};

struct RegistrationOptions {
  Fit fit = Fit::Gicp;
  /// Least share of a frame's points that must lie on the frames before it. A turntable's step of 30 degrees
  /// leaves about a half; a wrong fit reaches a quarter by chance.
  double min_overlap = 0.35;
};

/// Fits each frame to all placed frames before it, by PCL's ICP or GICP; the first has the identity. Refuses
/// a fit with too little overlap.
PoseSource registered_poses(const RegistrationOptions& options);

}  // namespace filmsticking::stream
