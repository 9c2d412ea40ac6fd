// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/surface.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// How well a film of sites agrees with the sites' own neighbourhoods. Knows no truth, so that a
/// reconstruction can judge itself.
struct SurfaceQuality {
  double disagreement =
      1;  ///< mean of 1 - |face normal . local normal| by area, of a face at most a sample's; 0 best
  double conflict = 1;  ///< share of pairs of near sites on the film whose normals oppose each other; 0 best
  std::int64_t wide_faces =
      0;                ///< faces with an empty circle of more than three spacings: plates and bridges
  double bridging = 0;  ///< their share of the area
  std::int64_t handles = 0;
  std::int64_t complexity = 0;  ///< components and handles, and half the holes with a rim
  std::int64_t off = 0;         ///< sites off the film
};

SurfaceQuality surface_quality(const Surface& film, const SiteGeometry& geometry);

}  // namespace filmsticking
