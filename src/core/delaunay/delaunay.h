// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/power_diagram.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// The Delaunay tetrahedra of some sites in canonical order. Sites that are on a space-filling curve make it
/// fast. The same tetrahedra for any number of threads; none if all sites are on a plane. Throws
/// TooManyTetrahedra as soon as some of the sites alone make more than are allowed.
Tetrahedra delaunay_tetrahedra(const std::vector<Vec3>& sites, const TriangulationLimits& limits = {});

/// The same in no particular order, by the rooms' own triangulation. False, and no tetrahedra, where it met
/// five sites on a sphere or four on a plane, so that there may be several triangulations.
///
/// Sites are inserted in rounds of eight times as many (Amenta, Choi and Rote, "Incremental constructions con
/// BRIO", 2003); each replaces the tetrahedra whose spheres it is in (Bowyer 1981, Watson 1981). Several
/// threads insert at once, each along its own part of the curve, and lock what they look at; a site that
/// meets a lock waits for the end of the round (Levy, "geogram", PDEL). Predicates are exact.
bool incremental_delaunay(const std::vector<Vec3>& sites, Tetrahedra& tets,
                          const TriangulationLimits& limits = {});

/// The Voronoi diagram that some Delaunay tetrahedra are dual to.
PowerDiagram voronoi_diagram(const Tetrahedra& tets, const std::vector<Vec3>& sites);

}  // namespace filmsticking
