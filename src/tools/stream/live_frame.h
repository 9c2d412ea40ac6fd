// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "io/model.h"

namespace filmsticking::stream {

/// Where a sensor is: takes its coordinates to those of the fixed frame.
using Pose = Eigen::Isometry3d;

/// Keeps the points whose distance from the origin, where the sensor is, lies within the bounds; 0 is no
/// bound.
void keep_range(io::Model& frame, double least, double most);

/// Moves all points and the viewpoint, in double precision.
void move(io::Model& frame, const Pose& pose);

}  // namespace filmsticking::stream
