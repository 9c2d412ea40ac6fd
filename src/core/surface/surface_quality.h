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
  /// Fraction of pairs of near sites on the surface whose normals oppose each other, unless they are back to
  /// back, as the two sides of a wall are; 0 is best.
  double conflict = 1;
  std::int64_t wide_faces = 0;  ///< faces with a circumradius above three spacings: plates and bridges
  double bridging = 0;          ///< their fraction of the area
  double area = 0;              ///< in samples: of each face over the squared spacing of its corners
  /// -log-likelihood of the faces' normals, in samples: the sum of ln(1 + d / kUsualDeviation) with d as in
  /// `disagreement`, by a face's area, at most one sample. Of a wide face no normal is known: it pays the mean, kAnyNormal.
  double roughness = 0;
  std::int64_t handles = 0;     ///< genus, summed over the components
  std::int64_t complexity = 0;  ///< components, handles and half the boundary loops
  std::int64_t off = 0;         ///< sites that are no vertex
};

/// 1 - cos of 8 degrees, by which faces of a smooth surface deviate from the fitted normals. Heavy tails
/// beyond: edges and limbs deviate by any angle. A third and three times choose the same on noisy solids with
/// openings.
constexpr double kUsualDeviation = 0.01;

/// What a normal of any direction costs: the mean of ln(1 + d / kUsualDeviation) over d from 0 to 1.
constexpr double kAnyNormal = 3.66;

/// `geometry`: of all sites. All vertices must be sites; the surface may be empty.
SurfaceQuality surface_quality(const Surface& surface, const SiteGeometry& geometry);

}  // namespace filmsticking
