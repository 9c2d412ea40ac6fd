// SPDX-License-Identifier: GPL-3.0-or-later
#include "above_plane.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace filmsticking::mesh_report {
namespace {

/// The mean over a triangle of max(height, 0), from its corners' heights.
double mean_above(std::array<double, 3> h) {
  std::sort(h.begin(), h.end());
  if (h[0] >= 0) return (h[0] + h[1] + h[2]) / 3;
  if (h[2] <= 0) return 0;
  // The plane cuts a triangle off at the corner that is alone on its side.
  if (h[1] <= 0) return h[2] * h[2] * h[2] / ((h[2] - h[0]) * (h[2] - h[1])) / 3;
  return (h[0] + h[1] + h[2]) / 3 - h[0] * h[0] * h[0] / ((h[0] - h[1]) * (h[0] - h[2])) / 3;
}

}  // namespace

PlaneVolumes plane_volumes(const Surface& surface, const Vec3& up, double offset) {
  const Frame frame = frame_of(surface.positions);  // in the unit box, where no product overflows
  const Surface unit = frame.to_unit(surface);
  const double side = frame.side > 0 ? frame.side : 1;
  const double unit_offset = (offset + up.dot(frame.centre)) / side;
  PlaneVolumes volumes;
  for (std::size_t f = 0; f < unit.triangles.size(); ++f) {
    const double area = unit.area_vector2(f).dot(up) / 2;
    std::array<double, 3> heights{};
    for (int k = 0; k < 3; ++k) heights[k] = up.dot(unit.corner(f, k)) + unit_offset;
    const double above = mean_above(heights), mean = (heights[0] + heights[1] + heights[2]) / 3;
    volumes.above += area * above;
    volumes.below += area * (above - mean);
    volumes.net += area * mean;
  }
  const double rounding = 1e-12 * (std::abs(volumes.above) + std::abs(volumes.below));
  for (double* volume : {&volumes.above, &volumes.below, &volumes.net})
    *volume = std::abs(*volume) <= rounding ? 0 : *volume * side * side * side;
  volumes.above = std::abs(volumes.above);
  volumes.below = std::abs(volumes.below);
  return volumes;
}

}  // namespace filmsticking::mesh_report
