// SPDX-License-Identifier: GPL-3.0-or-later
// Random sites, and the owner of a place by brute force.
#pragma once

#include <cstdint>
#include <vector>

#include "clouds.h"
#include "delaunay/power_diagram.h"

namespace filmsticking::test {

// In the box [-0.5, 0.5]^3.
inline std::vector<Vec3> random_sites(int n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> sites;
  for (int i = 0; i < n; ++i)
    sites.emplace_back(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
  return sites;
}

inline Index brute_owner(const PowerDiagram& diagram, const Vec3& x, const std::vector<char>& present) {
  Index best = kNone;
  for (Index i = 0; i < static_cast<Index>(diagram.position.size()); ++i)
    if (present[i] && (best == kNone || diagram.power(i, x) < diagram.power(best, x))) best = i;
  return best;
}

}  // namespace filmsticking::test
