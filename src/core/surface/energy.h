// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "surface/surface_quality.h"

namespace filmsticking {

/// Prices in the energy of a surface. The unit is the area of one sample, the square of the spacing.
struct EnergyPrices {
  double off = 5;  ///< of a site off the surface
  /// Of a site that joined the surface at the end, in sites off: it is on it, but not by itself.
  double inserted = 0.2;
  double complexity = 5;  ///< of a component or a handle, in sites off
  /// Of a site whose near sites all oppose it (SurfaceQuality::conflict), in samples. A sheet that winds from
  /// one side of the points to the other has such sites where it passes through.
  double conflict = 1;
  double sight = 5;  ///< of a line of sight for each spacing of its way through the inside: as a site off
};

/// What a surface of `sites` sites costs, per site; the least is the best. Points that are drawn from a
/// surface, one to an area of s^2, have a negative log-likelihood of its area over s^2. The normals of faces
/// around the fitted ones have another, SurfaceQuality::roughness. So a surface pays for its area, its
/// roughness, the sites off it, its handles and components, and neighbours that oppose each other. Infinite
/// for an empty surface. `inserted`: sites that joined it at the end.
///
/// A shell of noise torn into two skins has twice the area of a solid with a lid, and is nearly as rough. A
/// plate with both sides has twice the area of one layer that goes to and fro between them, and is smooth.
double surface_energy(const SurfaceQuality& quality, std::int64_t inserted, std::size_t sites,
                      const EnergyPrices& prices = {});

}  // namespace filmsticking
