// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "points/site_geometry.h"

namespace filmsticking {

/// The viewpoint of a depth image, from its pixels alone. Three neighbours in a row, column or diagonal of a
/// raster are coplanar with the viewpoint, whatever their depths. The viewpoint is where many such planes
/// meet, by iteratively reweighted least squares. Nothing if most planes do not meet: no raster.
///
/// May be wrong for points that happen to lie like pixels; depth_image() verifies it. Nothing if the
/// viewpoint is more than 30 box sides away: the planes do not determine it. `places`: in a box of side 1.
/// `guess`: is returned if the planes meet there too, as those of a far sensor meet along a line.
std::optional<Vec3> raster_viewpoint(const std::vector<Vec3>& places, const SiteGeometry& geometry,
                                     const std::optional<Vec3>& guess = {});

}  // namespace filmsticking
