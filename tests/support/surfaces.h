// SPDX-License-Identifier: GPL-3.0-or-later
// Small surfaces, on which the stages of surface/ are tested.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "clouds.h"
#include "film/initial_surface.h"
#include "filmsticking/types.h"
#include "geometry/surface.h"
#include "geometry/triangle_adjacency.h"

namespace filmsticking::test {

/// The faces of a tetrahedron with the corners 0 to 3.
inline const std::vector<Corners> kTetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// A surface whose vertex v is site v.
inline Surface surface_of(std::vector<Vec3> positions, std::vector<Corners> triangles) {
  Surface surface{std::move(positions), {}, std::move(triangles)};
  for (std::size_t v = 0; v < surface.positions.size(); ++v) surface.site.push_back(static_cast<Index>(v));
  return surface;
}

inline std::vector<Point> places_of(const Surface& surface) {
  std::vector<Point> places;
  for (const Vec3& p : surface.positions) places.push_back({p.x(), p.y(), p.z()});
  return places;
}

inline ManifoldCheck check(const Surface& surface) {
  return check_manifold(surface.triangles, static_cast<Index>(surface.positions.size()));
}

inline std::vector<Index> twins_of(const Surface& surface) {
  return half_edge_twins(surface.triangles, static_cast<Index>(surface.positions.size()));
}

/// Six times the enclosed volume of a closed surface, positive if it is oriented outward.
inline double signed_volume6(const Surface& surface) {
  double sum = 0;
  for (const Corners& t : surface.triangles)
    sum += surface.positions[t[0]].dot(surface.positions[t[1]].cross(surface.positions[t[2]]));
  return sum;
}

inline double area(const Surface& surface) {
  double sum = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    sum += surface.area_vector2(static_cast<Index>(t)).norm() / 2;
  return sum;
}

/// What one vertex covers: the square root of its share of the area.
inline double spacing(const Surface& surface) {
  return std::sqrt(area(surface) / static_cast<double>(surface.positions.size()));
}

inline Vec3 middle(const Surface& surface, Index t) {
  return (surface.corner(t, 0) + surface.corner(t, 1) + surface.corner(t, 2)) / 3;
}

/// A ball around the origin without the faces whose middles are `away`.
template <class Away>
Surface ball_without(const Away& away) {
  Surface ball = bounding_sphere({Vec3(0.5, 0.5, 0.5)});
  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < ball.triangles.size(); ++t)
    if (!away(middle(ball, static_cast<Index>(t)))) triangles.push_back(ball.triangles[t]);
  return surface_of(std::move(ball.positions), std::move(triangles));
}

inline Surface ball() {
  return ball_without([](const Vec3&) { return false; });
}

/// A square grid of n x n cells in the plane z = 0, `side` wide.
inline Surface square_sheet(int n, double side) {
  std::vector<Vec3> positions;
  std::vector<Corners> triangles;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) positions.emplace_back(side * i / n, side * j / n, 0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Index a = i * (n + 1) + j, b = a + n + 1;
      triangles.push_back({a, b, b + 1}), triangles.push_back({a, b + 1, a + 1});
    }
  return surface_of(std::move(positions), std::move(triangles));
}

}  // namespace filmsticking::test
