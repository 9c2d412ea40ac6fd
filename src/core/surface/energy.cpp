// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/energy.h"

#include <cmath>
#include <limits>

namespace filmsticking {

double surface_energy(const SurfaceQuality& quality, std::int64_t inserted, std::size_t sites,
                      const EnergyPrices& prices) {
  if (!(quality.area > 0)) return std::numeric_limits<double>::infinity();
  const auto n = static_cast<double>(sites);
  // Complexity counts half of the loops.
  const double parts = static_cast<double>(quality.complexity) + 0.5 * static_cast<double>(quality.loops);
  const double missed = static_cast<double>(quality.off) + prices.inserted * static_cast<double>(inserted);
  return (quality.area + prices.roughness * quality.roughness + prices.off * missed + std::log(n) * parts) / n;
}

}  // namespace filmsticking
