// SPDX-License-Identifier: GPL-3.0-or-later
#include "extent.h"

namespace filmsticking::mesh_report {

double area(const Surface& surface) {
  double sum = 0;
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) sum += surface.area_vector2(f).norm();
  return sum / 2;
}

double signed_volume(const Surface& surface) {
  double sum = 0;
  // Seen from a vertex: from a far origin the terms would swamp their sum.
  for (std::size_t f = 0; f < surface.triangles.size(); ++f)
    sum += surface.area_vector2(f).dot(surface.corner(f, 0) - surface.positions[0]);
  return sum / 6;
}

}  // namespace filmsticking::mesh_report
