// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "filmsticking/report.h"
#include "geometry/vec.h"

namespace filmsticking {

/// The vertices of a loop of boundary edges, in the direction of faces that would fill it. Not closed where
/// an edge with three faces takes an end away.
using Rim = std::vector<Index>;

/// A boundary edge, in the direction of a face that would fill it.
using RimEdge = std::array<Index, 2>;

/// The loops of boundary edges. A loop passes a vertex once: it is cut where it comes back. Each starts at
/// its least vertex; they are in the order of these, and of the next ones. Edges of faces that disagree in
/// orientation are followed in either direction.
std::vector<Rim> find_rims(std::vector<RimEdge> edges);

/// The boundary edges of a manifold. `twins`: its half_edge_twins().
std::vector<RimEdge> rim_edges(const std::vector<Corners>& triangles, const std::vector<Index>& twins);

/// What a hole with these corners measures, in their unit, wherever they are; not closed.
Hole measure_rim(const std::vector<Vec3>& corners);

}  // namespace filmsticking
