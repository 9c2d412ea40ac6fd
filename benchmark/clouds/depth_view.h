// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "filmsticking/types.h"
#include "sample.h"

namespace filmsticking::bench {

/// The view of a depth camera on a mesh: the first hits of the rays through the pixels of a
/// regular grid. It looks at the middle of the box, from two diagonals away, in a direction that the seed
/// chooses. `count` points: the pixels are as large as possible for that number, and surplus points are
/// left out at random. Throws std::invalid_argument for a mesh that no ray meets.
std::vector<Sample> sample_depth_view(const Mesh& mesh, std::size_t count, std::uint64_t seed);

/// From the mesh's frame to that of the camera, which is at the origin and looks along z.
Eigen::Isometry3d depth_camera_frame(const Mesh& mesh, std::uint64_t seed);

/// The part of the mesh that the same camera sees, in pieces of at most `size` across, longer where they are
/// thin, that are seen whole or not at all.
Mesh visible_part(const Mesh& mesh, std::uint64_t seed, double size);

}  // namespace filmsticking::bench
