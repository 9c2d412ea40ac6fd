// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "geometry/surface.h"
#include "geometry/work_limits.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// Removes faces of an open surface until no two meet except in common corners. The face that meets most
/// others goes first; among equals the one most turned against its neighbours. Where many sites lie exactly
/// in one plane, a few faces may be folded over others. The surface stays a manifold, with more boundary.
/// Vertices without a face are removed.
///
/// Independent of the numbering of vertices and faces. Fast if near faces have near numbers. A face that
/// meets 64 others or more is removed at once, so that work stays linear. Throws Cancelled. Returns the
/// number of faces removed because they meet others.
std::int64_t remove_meeting_faces(Surface& surface, const SiteGeometry& geometry, const Cancel& cancel = {});

}  // namespace filmsticking
