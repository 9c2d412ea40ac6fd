// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/viewpoint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/every_nth.h"
#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// Distances of trial viewpoints from the mean vertex, in the mean distance of the vertices from it. A nearer
// one could lie between two components that face each other: both would show it the same side.
constexpr double kDistances[] = {2, 4, 8, 32};
// Directions of trial viewpoints.
constexpr int kDirections = 128;
// First step of the local search, as a fraction of the distance; it is halved kStepSizes - 1 times.
constexpr double kFirstStep = 0.15;
constexpr int kStepSizes = 4, kStepsOfOneSize = 3;
// Most edges sampled.
constexpr std::size_t kEdges = 4000;
// Lines sampled: at most, and at least on a large surface, where kTests bounds the tests of a face by a line.
constexpr std::size_t kLines = 128, kFewLines = 16, kTests = 100'000'000;
// Fraction of lines that cross the surface again. <= 0.35: seen once. Measured: below 0.3 for noisy scans
// from one side, 0.5 or more for scans from all sides.
constexpr double kCrossAgain = 0.35;
// Distance along the line in longest edges of the face. Nearer crossings do not count.
constexpr double kFaceReach = 4;
// Turn at an edge in radians. More: a fold at the rim, neither a bend nor the edge of a box.
constexpr double kFold = 2;

struct Component {
  std::vector<Index> faces;
  double area2 = 0;  // twice the area
  bool open = false;
};

Vec3 middle(const Surface& surface, Index t) {
  return (surface.corner(t, 0) + surface.corner(t, 1) + surface.corner(t, 2)) / 3;
}

// The mean of the points, and their mean distance from it.
std::pair<Vec3, double> extent(const std::vector<Vec3>& points) {
  const auto n = static_cast<double>(points.size());
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : points) centre += p / n;
  double size = 0;
  for (const Vec3& p : points) size += (p - centre).norm() / n;
  return {centre, size};
}

// An edge between two faces: its middle and their unit normals.
struct Edge {
  Vec3 middle, left, right;
};

std::vector<Edge> some_edges(const Surface& surface) {
  const std::vector<Index> twin =
      half_edge_twins(surface.triangles, static_cast<Index>(surface.positions.size()));
  std::vector<Index> inner;
  for (Index h = 0; h < static_cast<Index>(twin.size()); ++h)
    if (twin[h] > h) inner.push_back(h);
  std::vector<Edge> edges;
  const EveryNth sample(inner.size(), kEdges);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const Index h = inner[sample[i]];
    edges.push_back({(surface.corner(h / 3, h % 3) + surface.corner(h / 3, (h + 1) % 3)) / 2,
                     surface.area_vector2(h / 3).normalized(),
                     surface.area_vector2(twin[h] / 3).normalized()});
  }
  return edges;
}

// How many times the line through x in a direction meets the surface at a distance of at least `beyond`, in
// lengths of the direction. `aside`: a face that does not count.
std::size_t crossings(const Surface& surface, const Vec3& x, const Vec3& along, double beyond,
                      Index aside = kNone) {
  return static_cast<std::size_t>(parallel_sum(surface.triangles.size(), [&](std::size_t t) {
    const auto face = static_cast<Index>(t);
    if (face == aside) return 0;
    const Vec3 a = surface.corner(face, 0) - x, b = surface.corner(face, 1) - x,
               c = surface.corner(face, 2) - x;
    const Vec3 bc = b.cross(c);
    const double u = along.dot(a.cross(b)), v = along.dot(bc), w = along.dot(c.cross(a));
    const bool crosses = (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
    // The line meets the plane of the face at a . bc / (u + v + w).
    return crosses && std::abs(a.dot(bc)) >= beyond * std::abs(u + v + w) ? 1 : 0;
  }));
}

// The fraction of sampled faces for which a test of a line through them holds; 0 without faces.
template <typename Test>
double share_of_lines(const Surface& surface, const Cancel& cancel, const Test& test) {
  const std::size_t n = surface.triangles.size();
  const EveryNth lines(n, std::clamp(kTests / (n + 1), kFewLines, kLines));
  std::size_t held = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    cancel();
    held += test(static_cast<Index>(lines[i]));
  }
  return lines.size() > 0 ? static_cast<double>(held) / static_cast<double>(lines.size()) : 0;
}

// The fraction of a component's area that shows its front to a point.
double seen_from(const Surface& surface, const Component& component, const Vec3& eye) {
  double seen = 0;
  for (Index t : component.faces) {
    const Vec3 area = surface.area_vector2(t);
    if (area.dot(eye - middle(surface, t)) > 0) seen += area.norm();
  }
  return component.area2 > 0 ? seen / component.area2 : 0;
}

// The sum over the edges of length times turn towards the back: positive if the front is convex on the whole.
// Long edges across gaps turn by chance, but are few.
double convexity(const Surface& surface, const SurfaceTopology& topology, const Component& component) {
  double sum = 0;
  for (Index t : component.faces)
    for (int k = 0; k < 3; ++k) {
      const Index h = 3 * t + k, twin = topology.twin[h];
      if (twin == kNone || twin < h) continue;
      const Vec3 a = surface.area_vector2(t), b = surface.area_vector2(twin / 3);
      const Vec3 edge = surface.corner(t, (k + 1) % 3) - surface.corner(t, k);
      const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
      // Where it turns to the back, the left normal leans left and the right normal leans right.
      if (angle < kFold) sum += std::copysign(edge.norm() * angle, a.cross(b).dot(edge));
    }
  return sum;
}

void turn(Surface& surface, const Component& component) {
  for (Index t : component.faces) std::swap(surface.triangles[t][1], surface.triangles[t][2]);
}

}  // namespace

Vec3 common_viewpoint(const Surface& surface) {
  const auto [centre, size] = extent(surface.positions);
  const std::vector<Edge> edges = some_edges(surface);
  Vec3 best = centre;
  if (edges.empty() || !(size > 0)) return best;
  double most = -std::numeric_limits<double>::infinity();
  const auto consider = [&](const Vec3& eye) {
    const double agreement = parallel_sum(edges.size(), [&](std::size_t i) {
      const Vec3 ray = (eye - edges[i].middle).normalized();
      const double both = edges[i].left.dot(ray) * edges[i].right.dot(ray);
      return std::copysign(std::sqrt(std::abs(both)), both);
    });
    if (agreement > most) most = agreement, best = eye;
  };
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1 - (2 * i + 1.0) / kDirections, r = std::sqrt(1 - z * z);
    const double a = 2.399963229728653 * i;  // the golden angle: even over the sphere
    for (const double distance : kDistances)
      consider(centre + distance * size * Vec3(r * std::cos(a), r * std::sin(a), z));
  }
  for (int halved = 0; halved < kStepSizes; ++halved)
    for (int again = 0; again < kStepsOfOneSize; ++again) {
      const double step = std::ldexp(kFirstStep, -halved);
      const Vec3 from = best - centre;
      const Vec3 x = from.unitOrthogonal() * from.norm(), y = from.normalized().cross(x);
      for (int i = 0; i < 6; ++i) {
        const double a = i * EIGEN_PI / 3;
        consider(centre + from + step * (std::cos(a) * x + std::sin(a) * y));
      }
      consider(centre + from * (1 + step));
      if (from.norm() > kDistances[0] * size * (1 + step)) consider(centre + from / (1 + step));
    }
  return best;
}

bool is_seen_once(const Surface& surface, const Vec3& viewpoint, const Cancel& cancel) {
  const auto crossed_again = [&](Index face) {
    const Vec3 x = middle(surface, face);
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, (surface.corner(face, k) - surface.corner(face, (k + 1) % 3)).norm());
    return crossings(surface, x, (viewpoint - x).normalized(), kFaceReach * longest) > 0;
  };
  return share_of_lines(surface, cancel, crossed_again) <= kCrossAgain;
}

double odd_crossing_share(const Surface& surface, const Vec3& viewpoint, const Cancel& cancel) {
  return share_of_lines(surface, cancel, [&](Index face) {
    const Vec3 x = middle(surface, face);
    return crossings(surface, x, viewpoint - x, 0, face) % 2 == 0;  // the face itself is one more
  });
}

double turned_away_share(const Surface& surface, const Vec3& viewpoint) {
  double all = 0, away = 0;
  for (Index t = 0; t < static_cast<Index>(surface.triangles.size()); ++t) {
    const Vec3 area = surface.area_vector2(t);
    all += area.norm();
    if (area.dot(viewpoint - surface.corner(t, 0)) < 0) away += area.norm();
  }
  return all > 0 ? std::min(away, all - away) / all : 0;
}

Index turn_to_viewpoint(Surface& surface, const SurfaceTopology& topology, const Cancel& cancel) {
  std::vector<Component> components(static_cast<std::size_t>(topology.components));
  for (Index t = 0; t < static_cast<Index>(topology.component.size()); ++t) {
    Component& component = components[topology.component[t]];
    component.faces.push_back(t);
    component.area2 += surface.area_vector2(t).norm();
    for (int k = 0; k < 3; ++k) component.open = component.open || topology.twin[3 * t + k] == kNone;
  }
  const auto smaller = [](const Component& a, const Component& b) {
    return std::pair(a.open, a.area2) < std::pair(b.open, b.area2);
  };
  const auto largest = std::max_element(components.begin(), components.end(), smaller);
  if (largest == components.end() || !largest->open) return 0;

  Index turned = 0;
  if (convexity(surface, topology, *largest) < 0) turn(surface, *largest), ++turned;
  if (std::count_if(components.begin(), components.end(), [](const Component& c) { return c.open; }) == 1)
    return turned;
  const Vec3 viewpoint = common_viewpoint(surface);
  if (!is_seen_once(surface, viewpoint, cancel)) return turned;
  // The viewpoint may be the one behind the surface.
  const bool front = seen_from(surface, *largest, viewpoint) > 0.5;
  for (const Component& component : components) {
    if (!component.open || &component == &*largest) continue;
    if ((seen_from(surface, component, viewpoint) > 0.5) == front) continue;
    turn(surface, component), ++turned;
  }
  return turned;
}

}  // namespace filmsticking
