// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "random.h"
#include "sample.h"
#include "surface_sampler.h"

namespace filmsticking::bench {

/// The mixed density of the paper's figures: the longest axis of the box is cut in thirds; the top third is
/// blue noise, the middle one Monte Carlo, the bottom one a sparse regular choice. Densities are as 4 : 2
/// : 1.
std::vector<Sample> sample_mixed_density(const SurfaceSampler& surface, std::size_t count, Random& random);

}  // namespace filmsticking::bench
