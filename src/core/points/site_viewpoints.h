// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filmsticking/options.h"
#include "points/site_set.h"

namespace filmsticking {

/// Where each site was seen from, in the frame of the sites; not finite: unknown. Empty if nothing is known.
/// By the first of Options::viewpoints, view_direction and viewpoint that is given; a sensor that looks in
/// one direction is 100 box sides away.
std::vector<Vec3> site_viewpoints(const SiteSet& sites, const Options& options);

}  // namespace filmsticking
