// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Turns over the components that show their backs to what saw them, by the angles at which the lines of sight
/// meet their faces: a room without a gap is closed, and shows its front to what stands inside. `component`:
/// [triangle]. `viewpoints`: [site], not finite if unknown. Returns the number of components turned.
Index turn_to_sensors(Surface& surface, const std::vector<Index>& component,
                      const std::vector<Vec3>& viewpoints);

}  // namespace filmsticking
