// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "points/site_geometry.h"
#include "points/site_set.h"

namespace filmsticking {

/// Removes outliers from the sites and updates the geometry. Returns how many were removed. `points`: the
/// points that the sites were made from.
///
/// A site is an outlier if it is far from its neighbours and not on one plane with them. Far is measured by
/// the neighbours' spacing or by the median spacing. Removing outliers makes further ones lonelier, so the
/// search repeats until it finds none. Removes nothing if more than a third of the sites would go, or if the
/// rest would lie on a plane: that is no surface with outliers.
std::int64_t drop_outliers(SiteSet& sites, const PointsView& points, SiteGeometry& geometry);

}  // namespace filmsticking
