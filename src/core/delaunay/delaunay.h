// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedra.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// The Delaunay tetrahedra of the sites in canonical order; none if all sites lie on a plane. The result does
/// not depend on the number of threads. Fast where the sites follow a space-filling curve. Throws
/// TooManyTetrahedra as soon as the sites inserted so far make more than the limit, and Cancelled.
Tetrahedra delaunay_tetrahedra(const std::vector<Vec3>& sites, const TriangulationLimits& limits = {});

/// The same in no particular order. Returns false, and no tetrahedra, if five sites lie on a sphere or four
/// on a plane: there may be several triangulations then. By hand, because CGAL's parallel triangulation has
/// neither a limit nor a cancel, and geogram is not in Debian 12.
///
/// Each round inserts eight times as many sites as the round before (Amenta, Choi and Rote, "Incremental
/// constructions con BRIO", 2003). A site replaces the tetrahedra whose circumspheres contain it (Bowyer
/// 1981, Watson 1981). Each thread inserts along its own part of the curve and locks the tetrahedra that it
/// visits. A site that meets a lock waits for the end of the round (Levy, "geogram", PDEL). Predicates are
/// exact.
bool incremental_delaunay(const std::vector<Vec3>& sites, Tetrahedra& tets,
                          const TriangulationLimits& limits = {});

}  // namespace filmsticking
