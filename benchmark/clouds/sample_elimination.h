// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sample.h"

namespace filmsticking::bench {

/// Candidates a kept sample for a good Poisson disk set.
constexpr std::size_t kCandidatesPerSample = 5;

/// Blue noise: leaves `count` of the candidates, which lie on a surface of the given area with `low` at the
/// corner of its box, by taking away again and again the one that has the most neighbours near (Yuksel,
/// Sample Elimination for Generating Poisson Disk Sample Sets, 2015). Candidates whose normals are further
/// than 90 degrees apart do not see each other, so that each side of a thin plate is sampled for itself.
std::vector<Sample> eliminate_samples(const std::vector<Sample>& candidates, std::size_t count, double area,
                                      const Vec3& low);

}  // namespace filmsticking::bench
