// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "points/site_geometry.h"

namespace filmsticking {

/// The viewpoint of a depth image, from its pixels alone: three neighbours in a row, a column or a diagonal
/// of a raster lie in one plane with it, whatever depths were measured. Found where the planes of many such
/// threes meet, by iteratively reweighted least squares. Nothing if most do not meet, as of points that are
/// no raster.
///
/// What is found of points that happen to lie like pixels may be wrong: depth_image() tells. Of a view from
/// farther than some sizes of the box, nothing is found: it has no place. `places`: in a box of side 1.
std::optional<Vec3> raster_viewpoint(const std::vector<Vec3>& places, const SiteGeometry& geometry);

}  // namespace filmsticking
