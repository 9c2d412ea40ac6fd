// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface.h"

namespace filmsticking::mesh_report {

/// How large a surface is.
struct Extent {
  double area = 0;
  /// Volume inside a closed, oriented surface; negative if it winds inward. Cavities, which wind inward, are
  /// subtracted. Without meaning for other surfaces.
  double signed_volume = 0;
};

Extent extent(const Surface& surface);

}  // namespace filmsticking::mesh_report
