// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "points/site_geometry.h"
#include "points/site_set.h"

namespace filmsticking {

/// Takes outliers out of the sites, and their geometry to what it is without them; returns how many. A site
/// is one if it is far from its neighbours, by their own spacing or that of the median site, and these are
/// not on one plane with it. Without the plainest the next are lonelier, so it looks again as long as it
/// finds any. `points`: what the sites were made of. Nothing is taken if a third of the sites would go, or
/// all but some on a plane: that is no cloud of a surface with outliers. Ends: every pass but the last takes
/// sites away.
std::int64_t drop_outliers(SiteSet& sites, const PointsView& points, SiteGeometry& geometry);

}  // namespace filmsticking
