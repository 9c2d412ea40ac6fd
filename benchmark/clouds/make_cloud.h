// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cloud_spec.h"
#include "filmsticking/types.h"
#include "sample.h"

namespace filmsticking::bench {

/// The points that `spec` asks for, in random order, rounded to single precision, and distinct, but for
/// outliers by chance. Throws std::invalid_argument for a mesh without area or a spec out of its
/// ranges.
std::vector<Point> make_cloud(const Mesh& mesh, const CloudSpec& spec);

/// The same with the normal of the face that each point was drawn from; zero for outliers and vertices.
std::vector<Sample> make_samples(const Mesh& mesh, const CloudSpec& spec);

/// The surface that the points are drawn from: the mesh, or its part that the depth camera sees.
Mesh sampled_part(const Mesh& mesh, const CloudSpec& spec);

}  // namespace filmsticking::bench
