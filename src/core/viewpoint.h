// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "guiding_surface.h"
#include "triangle_adjacency.h"

namespace filmsticking {

/// Turns the open components of a manifold to one viewpoint. A scan from one side is seen from one point,
/// from which every face shows its front; the components themselves cannot tell, for nothing joins them. The
/// point is looked for in front of the largest open component, whose front is the side that is convex on the
/// whole, as things are. Where nearly all of it is seen from no such point, it is no scan from one side, and
/// no other is turned. `topology`: that of its triangles before. Returns how many components were turned.
Index face_viewpoint(GuidingSurface& surface, const SurfaceTopology& topology);

}  // namespace filmsticking
