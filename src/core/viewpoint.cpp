// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewpoint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace filmsticking {
namespace {

// How far from the middle of the component the point is looked for, in its mean distance from there: within a
// room that was scanned, in front of an object, and as good as at infinity.
constexpr double kDistances[] = {0.25, 0.5, 1, 2, 4, 8, 32};
// The share of the largest component that must be seen. Faces along the line of sight are seen or not by
// noise.
constexpr double kSeen = 0.9;

struct Component {
  std::vector<Index> faces;
  double area = 0;
  bool open = false;
};

Vec3 area_vector(const GuidingSurface& surface, Index t) {
  const Vec3 a = surface.corner(t, 0);
  return (surface.corner(t, 1) - a).cross(surface.corner(t, 2) - a) / 2;
}

Vec3 middle(const GuidingSurface& surface, Index t) {
  return (surface.corner(t, 0) + surface.corner(t, 1) + surface.corner(t, 2)) / 3;
}

// The share of its area that shows its front to a point.
double seen_from(const GuidingSurface& surface, const Component& component, const Vec3& eye) {
  double seen = 0;
  for (Index t : component.faces) {
    const Vec3 area = area_vector(surface, t);
    if (area.dot(eye - middle(surface, t)) > 0) seen += area.norm();
  }
  return component.area > 0 ? seen / component.area : 0;
}

// How much it bends towards its back: over its edges, the length times the angle between their faces. Long
// edges, across gaps, bend by chance and are counted like the others: there are few.
double convexity(const GuidingSurface& surface, const SurfaceTopology& topology, const Component& component) {
  double sum = 0;
  for (Index t : component.faces)
    for (int k = 0; k < 3; ++k) {
      const Index h = 3 * t + k, twin = topology.twin[h];
      if (twin == kNone || twin < h) continue;
      const Vec3 a = area_vector(surface, t), b = area_vector(surface, twin / 3);
      const Vec3 edge = surface.corner(t, (k + 1) % 3) - surface.corner(t, k);
      // The left face leans to the left and the right one to the right where it bends towards its back.
      sum += std::copysign(edge.norm() * std::atan2(a.cross(b).norm(), a.dot(b)), a.cross(b).dot(edge));
    }
  return sum;
}

void turn(GuidingSurface& surface, const Component& component) {
  for (Index t : component.faces) std::swap(surface.triangles[t][1], surface.triangles[t][2]);
}

}  // namespace

Index face_viewpoint(GuidingSurface& surface, const SurfaceTopology& topology) {
  std::vector<Component> components(static_cast<std::size_t>(topology.components));
  for (Index t = 0; t < static_cast<Index>(topology.component.size()); ++t) {
    Component& component = components[topology.component[t]];
    component.faces.push_back(t);
    component.area += area_vector(surface, t).norm();
    for (int k = 0; k < 3; ++k) component.open = component.open || topology.twin[3 * t + k] == kNone;
  }
  const auto smaller = [](const Component& a, const Component& b) {
    return std::pair(a.open, a.area) < std::pair(b.open, b.area);
  };
  const auto largest = std::max_element(components.begin(), components.end(), smaller);
  if (largest == components.end() || !largest->open) return 0;

  Index turned = 0;
  if (convexity(surface, topology, *largest) < 0) turn(surface, *largest), ++turned;
  Vec3 centre = Vec3::Zero(), ahead = Vec3::Zero();
  for (Index t : largest->faces) {
    const Vec3 area = area_vector(surface, t);
    centre += area.norm() / largest->area * middle(surface, t);
    ahead += area;
  }
  double size = 0;
  for (Index t : largest->faces)
    size += area_vector(surface, t).norm() / largest->area * (middle(surface, t) - centre).norm();
  Vec3 eye = centre;
  double most = 0;
  for (const double distance : kDistances) {
    const Vec3 there = centre + distance * size * ahead.normalized();
    const double seen = seen_from(surface, *largest, there);
    if (seen > most) most = seen, eye = there;
  }
  if (!(most >= kSeen)) return turned;

  for (const Component& component : components) {
    if (!component.open || &component == &*largest || seen_from(surface, component, eye) >= 0.5) continue;
    turn(surface, component), ++turned;
  }
  return turned;
}

}  // namespace filmsticking
