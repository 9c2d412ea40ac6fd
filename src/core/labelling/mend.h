// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "labelling/labelling.h"

namespace filmsticking {

/// Mends what chance and noise broke, where that costs less than it is worth. Where samples are random, both
/// sides of a thin wall have a gap at the same place now and then, which leaves a tunnel that no samples
/// line. A wall thinner than the spacing may be torn all along a valley, and a thin limb across. Noise builds
/// bridges between sides that are near. A mouth of a few spacings may be barred.
///
/// It tries, with `sites` the corners of the tetrahedra: caps(), ways() from shards, discs() across tunnels
/// and bridges, and last bars(). A mend is kept if it leaves fewer handles or fewer pieces, and not more of
/// either (Mending). Needs a census.
void mend(Labelling& labelling, const std::vector<Vec3>& sites);

/// Before it: tries plugs(), the quickest mend of most gaps. Returns the number of mends.
std::int64_t plug_gaps(Labelling& labelling);

}  // namespace filmsticking
