// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "delaunay/tetrahedra.h"

namespace filmsticking {

/// The same tetrahedra in an order that depends on nothing but the set of tetrahedra. The corners of each
/// rise, kNone last; the last two are swapped where the orientation asks for it. The tetrahedra rise by their
/// corners. Where the sites follow a space-filling curve, so do the tetrahedra.
Tetrahedra in_canonical_order(Tetrahedra tets, std::size_t sites);

}  // namespace filmsticking
