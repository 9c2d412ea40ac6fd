// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random.h"
#include "scan_kinds.h"

namespace filmsticking::bench {

/// A room with two to four cupboards as two to four laser scanners on tripods see it; noise along the rays.
/// `corner`: the room is an L, and both of its arms have a scanner.
Scan make_room(Random& random, bool corner);

/// A yard with walls, cars and poles as a spinning lidar of 32 beams, 1.8 above the ground, sees it.
Scan make_lidar(Random& random);

/// A raster of heights, 90 by 70, with two cliffs and two or three holes without data; seen from above.
Scan make_cliffs(Random& random);

/// Soundings of a sea bed: degrees east, degrees north, and metres up; seen from above.
Scan make_sea_bed(Random& random);

}  // namespace filmsticking::bench
