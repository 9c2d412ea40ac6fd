// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface.h"

namespace filmsticking::mesh_report {

/// The sum of the faces' areas.
double area(const Surface& surface);

/// What a closed, oriented surface encloses; negative if it winds inward. Cavities that wind inward, as they
/// should, are taken off.
double signed_volume(const Surface& surface);

}  // namespace filmsticking::mesh_report
