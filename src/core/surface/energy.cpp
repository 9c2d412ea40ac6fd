// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/energy.h"

#include <limits>

namespace filmsticking {

double surface_energy(const SurfaceQuality& quality, std::int64_t inserted, std::size_t sites,
                      const EnergyPrices& prices) {
  if (!(quality.area > 0)) return std::numeric_limits<double>::infinity();
  const double off = static_cast<double>(quality.off) + prices.inserted * static_cast<double>(inserted) +
                     prices.complexity * static_cast<double>(quality.complexity);
  return prices.conflict * quality.conflict +
         (quality.area + quality.roughness + prices.off * off) / static_cast<double>(sites);
}

}  // namespace filmsticking
