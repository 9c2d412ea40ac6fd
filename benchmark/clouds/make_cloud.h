// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cloud_spec.h"
#include "filmsticking/types.h"

namespace filmsticking::bench {

/// The points that `spec` asks for, in random order, rounded to single precision, and no two the same (but
/// by a wonder among the outliers). Throws std::invalid_argument for a mesh without area or a spec out of its
/// ranges.
std::vector<Point> make_cloud(const Mesh& mesh, const CloudSpec& spec);

/// What the points of the cloud can be of: the mesh, or of a depth view what the camera sees of it.
Mesh sampled_part(const Mesh& mesh, const CloudSpec& spec);

}  // namespace filmsticking::bench
