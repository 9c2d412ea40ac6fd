// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface.h"

namespace filmsticking::mesh_report {

/// How large a surface is.
struct Extent {
  double area = 0;
  /// What a closed, oriented surface encloses; negative if it winds inward. Cavities that wind inward, as
  /// they should, are taken off. Without meaning for others.
  double signed_volume = 0;
};

Extent extent(const Surface& surface);

}  // namespace filmsticking::mesh_report
