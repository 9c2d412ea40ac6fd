// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "delaunay/power_diagram.h"

namespace filmsticking {

/// The same tetrahedra in an order, and with their corners in one, that depends on nothing but which they
/// are: by rising corners, the last two of which are swapped where the tetrahedron would be inside out. kNone
/// comes last. Where the sites are along a space-filling curve, so are the tetrahedra.
Tetrahedra in_canonical_order(Tetrahedra tets, std::size_t sites);

}  // namespace filmsticking
