// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <cstdint>

#include "ground_plane.h"

namespace filmsticking::filters {

/// What stands on the ground, with points added so that a closed surface ends on it.
struct OnGround {
  pcl::PCLPointCloud2 points;  ///< those kept, in order, then those added
  GroundPlane plane;
  std::int64_t on_plane = 0;  ///< left out: part of the ground, or below it
  std::int64_t added = 0;     ///< the last of `points`; fields other than x, y, z are zero
};

/// Finds the ground unless it is given, and leaves its points out. Adds a grid of points to the plane under
/// what stands on it, and columns of points where its outline is in the air, straight down: what a scanner
/// above does not see. Nothing stands where the ground is seen. Only points with finite coordinates are kept.
/// Throws FilterError where nothing stands on the plane.
OnGround on_ground(const pcl::PCLPointCloud2& cloud, const GroundChoice& ground);

}  // namespace filmsticking::filters
