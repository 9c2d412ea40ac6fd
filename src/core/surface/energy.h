// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "surface/surface_quality.h"

namespace filmsticking {

/// Prices in the energy of a surface. The unit is the area of one sample, the square of the spacing.
struct EnergyPrices {
  /// Of an area of one sample whose face is perpendicular to the fitted normals, over that of one that agrees:
  /// 1 / sigma^2, where faces between random samples deviate by sigma, 17 degrees.
  double roughness = 11;
  double off = 5;  ///< of a site off the surface
  /// Of a site that joined the surface at the end, in sites off: it is on it, but not by itself.
  double inserted = 0.2;
};

/// What a surface of `sites` sites costs, per site; the least is the best. Points that are drawn from a
/// surface, one to an area of s^2, have a negative log-likelihood of its area over s^2, and of the squared
/// angles of its faces over sigma^2. So a surface pays for its area, its roughness and the sites off it. A
/// handle, a component or a boundary loop costs log(sites): a gap of A samples' area is at one of so many
/// places by chance with probability sites * exp(-A). Infinite for an empty surface. `inserted`: sites that
/// joined it at the end.
///
/// This compares all candidates of a reconstruction: a thin wall torn in two layers has twice the area of a
/// solid with a lid, and a plate with both sides is smoother than one layer that goes to and fro.
double surface_energy(const SurfaceQuality& quality, std::int64_t inserted, std::size_t sites,
                      const EnergyPrices& prices = {});

}  // namespace filmsticking
