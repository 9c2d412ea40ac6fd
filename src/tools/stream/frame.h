// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>

namespace filmsticking::capture {

/// A rigid motion from a sensor's coordinates to the world's.
using Pose = Eigen::Isometry3d;

/// What a scanner saw at one time.
struct Frame {
  std::string name;                     ///< for people: a file's name, or a number
  std::optional<double> time;           ///< seconds, on the clock of the recording; none where it is not told
  pcl::PCLPointCloud2 cloud;            ///< in the sensor's coordinates
  Pose sensor_pose = Pose::Identity();  ///< that came with the cloud; the identity if none did
};

}  // namespace filmsticking::capture
