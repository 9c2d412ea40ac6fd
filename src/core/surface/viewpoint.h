// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/surface.h"
#include "geometry/triangle_adjacency.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// The point from which neighbouring faces agree most in the side that they show, whichever way components
/// are oriented. For a scan from one side it is near the sensor, or its mirror image behind the surface: the
/// two look alike. Searched around the surface, not inside it. Arbitrary for a surface without interior
/// edges.
Vec3 common_viewpoint(const Surface& surface);

/// Do most lines through the viewpoint cross the surface at most once? True for a scan from there.
bool is_seen_once(const Surface& surface, const Vec3& viewpoint, const Cancel& cancel = {});

/// The fraction of the lines from the viewpoint through the surface that cross it an odd number of times.
/// Near 0 for a closed surface, however thin; near 1 for a surface seen from there.
double odd_crossing_share(const Surface& surface, const Vec3& viewpoint, const Cancel& cancel = {});

/// The fraction of the area that shows the viewpoint another side than most of the area; at most a half.
double turned_away_share(const Surface& surface, const Vec3& viewpoint);

/// Orients the open components of a manifold towards one viewpoint. The largest shows the side that is convex
/// on the whole. If the surface is a scan from one side (is_seen_once()), the others show the same side as
/// the largest to common_viewpoint(); else they stay. `topology`: that of the triangles before. Returns the
/// number of components turned.
Index turn_to_viewpoint(Surface& surface, const SurfaceTopology& topology, const Cancel& cancel = {});

}  // namespace filmsticking
