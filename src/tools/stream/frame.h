// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace filmsticking::stream {

/// A rigid motion from a sensor's coordinates to the world's.
using Pose = Eigen::Isometry3d;

/// One cloud of a sensor.
struct Frame {
  std::string name;                     ///< a file's name, or a number, for messages to the user
  std::optional<double> time;           ///< seconds on the clock of the recording; none if it is unknown
  pcl::PCLPointCloud2 cloud;            ///< in the sensor's coordinates, with all fields
  std::vector<std::string> notes;       ///< how its file was read, where that is not plain: sentences
  Pose sensor_pose = Pose::Identity();  ///< where the sensor was; the identity if that is unknown
};

}  // namespace filmsticking::stream
