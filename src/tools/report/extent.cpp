// SPDX-License-Identifier: GPL-3.0-or-later
#include "extent.h"

namespace filmsticking::mesh_report {

Extent extent(const Surface& surface) {
  // In the unit box: products neither overflow nor vanish, and a far origin does not swamp the volume.
  const Frame frame = frame_of(surface.positions);
  const Surface unit = frame.to_unit(surface);
  Extent result;
  for (std::size_t f = 0; f < unit.triangles.size(); ++f) {
    const Vec3 area_vector2 = unit.area_vector2(f);
    result.area += area_vector2.norm() / 2;
    result.signed_volume += area_vector2.dot(unit.corner(f, 0)) / 6;
  }
  result.area *= frame.side * frame.side;
  result.signed_volume *= frame.side * frame.side * frame.side;
  return result;
}

}  // namespace filmsticking::mesh_report
