// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/surface.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// Fills the small holes of an open surface: boundary loops of at most twelve edges, by their triangulation
/// of least area (Barequet and Sharir 1995, "Filling gaps in the boundary of a polyhedron"). A hole is filled
/// only if no new face is a bridge face, turns against the faces around, or meets another face. The rim of a
/// component is no hole: its filling would face the other way.
///
/// The surface stays a manifold with the same vertices. Independent of the numbering of vertices and faces.
/// `twins`: the half_edge_twins() before. `viewpoint`: all faces show their fronts to it, the new ones too;
/// or null. Fast if near faces have near numbers. Returns the number of holes filled.
std::int64_t fill_pinholes(Surface& surface, const std::vector<Index>& twins, const SiteGeometry& geometry,
                           const Vec3* viewpoint = nullptr);

}  // namespace filmsticking
