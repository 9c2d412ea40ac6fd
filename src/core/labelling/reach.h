// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "labelling/labelling.h"

namespace filmsticking {

/// Takes sites onto the surface that the cut missed, since that was cheaper: sites that stick out, or are in
/// a dent of chance. A move relabels one or two tetrahedra at the site, keeps the topology, makes no fold and
/// costs less than the site is worth. It is sculpting (Boissonnat, "Geometric structures for
/// three-dimensional shape representation", 1984) in both directions. Needs a census.
void reach(Labelling& labelling);

}  // namespace filmsticking
