// SPDX-License-Identifier: GPL-3.0-or-later
// Short names for positions and indices.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace filmsticking {

using Vec3 = Eigen::Vector3d;
using Index = std::int32_t;
using Corners = std::array<Index, 3>;

constexpr Index kNone = -1;  // no vertex, site, face, half-edge or tetrahedron

}  // namespace filmsticking
