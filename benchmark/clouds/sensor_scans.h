// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random.h"
#include "scan_kinds.h"

namespace filmsticking::bench {

/// A torso with two lobes, on 25 parallel planes four to six times as far apart as points of a contour.
Scan make_slices(Random& random);

/// A room of 10 by 6 by 3 as a spinning lidar in its middle sees it: 16 beams, 45 degrees up to 45 down.
Scan make_rings(Random& random);

/// A walking figure, 1.8 high, as three depth cameras around it see it.
Scan make_figure(Random& random);

}  // namespace filmsticking::bench
