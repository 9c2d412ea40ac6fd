// SPDX-License-Identifier: GPL-3.0-or-later
// Random sites, and their powers by brute force.
#pragma once

#include <cstdint>
#include <vector>

#include "clouds.h"
#include "geometry/vec.h"

namespace filmsticking::test {

// In the box [-0.5, 0.5]^3.
inline std::vector<Vec3> random_sites(int n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> sites;
  for (int i = 0; i < n; ++i)
    sites.emplace_back(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
  return sites;
}

// |x-p|^2 - w of a site; `weights` may be empty.
inline double power(const std::vector<Vec3>& sites, const std::vector<double>& weights, std::size_t i,
                    const Vec3& x) {
  return (x - sites[i]).squaredNorm() - (weights.empty() ? 0 : weights[i]);
}

}  // namespace filmsticking::test
