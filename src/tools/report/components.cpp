// SPDX-License-Identifier: GPL-3.0-or-later
#include "components.h"

#include <algorithm>
#include <utility>

#include "disjoint_sets.h"
#include "extent.h"
#include "topology.h"

namespace filmsticking::mesh_report {
namespace {

/// Each component as a surface, in the order of their first faces.
std::vector<Surface> split(const Surface& surface) {
  const std::size_t vertices = surface.positions.size();
  DisjointSets pieces(vertices);
  for (const Triangle& t : surface.triangles) {
    pieces.join(t[0], t[1]);
    pieces.join(t[1], t[2]);
  }
  std::vector<std::int32_t> part_of(vertices, -1), index(vertices, -1);  // the first by the set's element
  std::vector<Surface> parts;
  for (const Triangle& t : surface.triangles) {
    std::int32_t& part = part_of[pieces.find(t[0])];
    if (part < 0) {
      part = static_cast<std::int32_t>(parts.size());
      parts.emplace_back();
    }
    Surface& to = parts[part];
    Triangle corners = t;
    for (std::int32_t& corner : corners) {
      if (index[corner] < 0) {
        index[corner] = static_cast<std::int32_t>(to.positions.size());
        to.positions.push_back(surface.positions[corner]);
      }
      corner = index[corner];
    }
    to.triangles.push_back(corners);
  }
  return parts;
}

Component measure(const Surface& surface) {
  const Topology shape = topology(surface);
  const Extent size = extent(surface);
  Component component{static_cast<std::int64_t>(surface.triangles.size()), shape.closed, size.area, {}};
  if (shape.closed && shape.oriented) component.volume = size.signed_volume;
  return component;
}

}  // namespace

std::vector<Component> components(const Surface& surface) {
  std::vector<Component> result;
  for (const Surface& part : split(surface)) result.push_back(measure(part));
  std::stable_sort(result.begin(), result.end(),
                   [](const Component& a, const Component& b) { return a.area > b.area; });
  return result;
}

}  // namespace filmsticking::mesh_report
