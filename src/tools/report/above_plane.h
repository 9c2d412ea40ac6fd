// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface.h"

namespace filmsticking::mesh_report {

/// Volumes between a surface and a plane.
struct PlaneVolumes {
  double above = 0;  ///< under the surface and above the plane: fill
  double below = 0;  ///< over the surface and below the plane: cut
  double net = 0;    ///< of an open surface above less below, where noise cancels; of a closed one their sum
};

/// The heights of faces over the plane, integrated over their areas as seen from above, where a face that
/// looks down counts negative; of `above` and `below` the size. Of a closed surface: its volume on either
/// side. Of an open one: as if its rim went straight to the plane. `up` has length 1; the plane is up . p +
/// offset = 0.
PlaneVolumes plane_volumes(const Surface& surface, const Vec3& up, double offset);

}  // namespace filmsticking::mesh_report
