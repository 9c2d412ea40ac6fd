// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/surface.h"
#include "geometry/triangle_adjacency.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// The point to which neighbouring faces most agree in the side that they show, whichever way the parts of
/// the surface are turned: of a scan from one side, about where it was taken from, or opposite, behind the
/// surface, of which all the same is true. Looked for around the surface, not within. A surface without edges
/// inside has none; then it is somewhere.
Vec3 common_viewpoint(const Surface& surface);

/// Do most lines through that point cross the surface no more than once? So they do if it is a scan from
/// there.
bool seen_once(const Surface& surface, const Vec3& viewpoint, const Cancel& cancel = {});

/// The share of the lines from that point through the surface that cross it an odd number of times: hardly
/// one of what has two sides, thin as it may be, and most of what was seen from there.
double crossed_oddly(const Surface& surface, const Vec3& viewpoint, const Cancel& cancel = {});

/// The share of the area that shows a point another side than most of the area does; a half at most.
double turned_away(const Surface& surface, const Vec3& viewpoint);

/// Turns the open components of a manifold to one viewpoint. A scan from one side is seen from one point,
/// from which every face shows its front; the components themselves cannot tell, for nothing joins them. The
/// front of the largest open component is the side that is convex on the whole, as things are; the others
/// show theirs where it does. Where it is no scan from one side, no other is turned. `topology`: that of its
/// triangles before. Returns how many components were turned.
Index face_viewpoint(Surface& surface, const SurfaceTopology& topology, const Cancel& cancel = {});

}  // namespace filmsticking
