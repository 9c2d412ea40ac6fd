// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "geometry/surface.h"
#include "geometry/work_limits.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// Takes faces away from an open film until no two meet but in their common corners: that which meets most
/// others first, and of such the one that is turned most against the faces around. Where many sites lie in
/// one plane exactly, a few faces may be folded over onto others. The manifold stays one, with more boundary;
/// vertices without a face are gone.
///
/// The same for any numbering of vertices and faces. Faces that are near each other should have near numbers.
/// Returns how many were taken for that. One that meets 64 others or more goes at once.
std::int64_t remove_meeting_faces(Surface& film, const SiteGeometry& geometry, const Cancel& cancel = {});

}  // namespace filmsticking
