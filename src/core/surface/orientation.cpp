// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/orientation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/enclosed_volume.h"

namespace filmsticking {

double solid_angle_winding(const Surface& surface, const std::vector<Index>& triangles, const Vec3& x) {
  double sum = 0;
  for (Index t : triangles) {
    const Vec3 a = surface.corner(t, 0) - x, b = surface.corner(t, 1) - x, c = surface.corner(t, 2) - x;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2 * M_PI);
}

bool orient_components(Surface& surface, const PointsView& places, const SurfaceTopology& topology) {
  const std::vector<Index>&component = topology.component, &twin = topology.twin;
  const Index count = topology.components;
  std::vector<std::vector<Index>> members(count);
  for (std::size_t t = 0; t < component.size(); ++t) members[component[t]].push_back(static_cast<Index>(t));
  std::vector<char> closed(count, 1);
  for (std::size_t h = 0; h < twin.size(); ++h)
    if (twin[h] == kNone) closed[component[h / 3]] = 0;
  std::vector<int> volume(count, 0);  // its sign
  std::vector<double> size(count, 0);
  const double unit = enclosing_unit(places);
  std::vector<Vec3> lo(count, Vec3::Constant(1e300)), hi(count, Vec3::Constant(-1e300));
  for (Index c = 0; c < count; ++c) {
    if (!closed[c]) continue;
    std::vector<Corners> triangles;
    for (Index t : members[c]) {
      triangles.push_back(surface.triangles[t]);
      for (int k = 0; k < 3; ++k) {
        lo[c] = lo[c].cwiseMin(surface.corner(t, k));
        hi[c] = hi[c].cwiseMax(surface.corner(t, k));
      }
    }
    volume[c] = enclosed_volume_sign(triangles, places);
    size[c] = rounded_volume(triangles, places, unit);
  }
  // Largest first: a component lies only inside larger ones, which are oriented by then. A flat one contains
  // nothing, although a point on its plane may have a winding number.
  std::vector<Index> order;
  for (Index c = 0; c < count; ++c)
    if (closed[c]) order.push_back(c);
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return size[a] != size[b] ? size[a] > size[b] : a < b; });
  std::vector<double> space = size;  // its volume without the components inside it
  std::vector<char> cavity(count, 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Index c = order[i];
    const Vec3 x = surface.corner(members[c][0], 0);
    Index around = kNone;  // the smallest, the last in the order
    for (std::size_t j = 0; j < i; ++j) {
      const Index other = order[j];
      if ((x.array() < lo[other].array()).any() || (x.array() > hi[other].array()).any()) continue;
      if (std::abs(solid_angle_winding(surface, members[other], x)) > 0.5) around = other;
    }
    // A component that does not fit lies inside by self-intersection only.
    if (around != kNone && space[around] > size[c]) space[around] -= size[c], cavity[c] = !cavity[around];
    if ((volume[c] < 0) == (cavity[c] != 0)) continue;
    for (Index t : members[c]) std::swap(surface.triangles[t][1], surface.triangles[t][2]);
  }
  return std::any_of(volume.begin(), volume.end(), [](int sign) { return sign != 0; }) ||
         order.size() < static_cast<std::size_t>(count);
}

}  // namespace filmsticking
