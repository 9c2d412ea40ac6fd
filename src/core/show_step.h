// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filmsticking/report.h"
#include "geometry/monitor.h"
#include "geometry/surface.h"
#include "points/site_set.h"

namespace filmsticking {

/// Shows a surface among the perturbed sites to the caller, in his coordinates, if he watches the steps.
/// Throws CallbackThrew.
void show_step(const Surface& surface, const SiteSet& sites, const Monitor& monitor, const Report& report);

}  // namespace filmsticking
