// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/surface.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// How well a surface of sites agrees with the neighbourhoods of the sites. Needs no ground truth, so a
/// reconstruction can compare its own results.
struct SurfaceQuality {
  /// Mean of 1 - |face normal . fitted normal| by area; 0 is best. A face counts at most one sample's area.
  double disagreement = 1;
  /// Fraction of pairs of near sites on the surface whose normals oppose each other; 0 is best.
  double conflict = 1;
  std::int64_t wide_faces = 0;  ///< faces with a circumradius above three spacings: plates and bridges
  double bridging = 0;          ///< their fraction of the area
  std::int64_t handles = 0;     ///< genus, summed over the components
  std::int64_t complexity = 0;  ///< components, handles and half the boundary loops
  std::int64_t off = 0;         ///< sites that are no vertex
};

/// `geometry`: of all sites. All vertices must be sites; the surface may be empty.
SurfaceQuality surface_quality(const Surface& surface, const SiteGeometry& geometry);

}  // namespace filmsticking
