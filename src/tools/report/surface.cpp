// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace filmsticking::mesh_report {
namespace {

constexpr double kFarthest = 1e100;

/// For each position the first one at the same place; -0 is 0.
std::vector<std::int32_t> first_at_place(const std::vector<Point>& positions) {
  std::vector<std::int32_t> order, first(positions.size(), -1);
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (usable(positions[i])) order.push_back(static_cast<std::int32_t>(i));
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return positions[a] != positions[b] ? positions[a] < positions[b] : a < b;
  });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && positions[order[k]] == positions[order[k - 1]];
    first[order[k]] = same ? first[order[k - 1]] : order[k];
  }
  return first;
}

}  // namespace

bool usable(const Point& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::abs(x) <= kFarthest; });
}

Vec3 Surface::area_vector2(std::size_t triangle) const {
  const Vec3& a = corner(triangle, 0);
  return (corner(triangle, 1) - a).cross(corner(triangle, 2) - a);
}

Surface make_surface(const pcl::PolygonMesh& mesh) {
  Surface surface;
  const std::vector<Point> positions = io::positions_of(mesh.cloud);
  const std::vector<std::int32_t> first = first_at_place(positions);
  std::vector<std::int32_t> vertex(positions.size(), -1);
  for (const Triangle& t : io::triangles_of(mesh.polygons)) {
    Triangle corners{first[t[0]], first[t[1]], first[t[2]]};
    if (*std::min_element(corners.begin(), corners.end()) < 0) continue;
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (std::int32_t& corner : corners) {
      std::int32_t& id = vertex[corner];
      if (id < 0) {
        id = static_cast<std::int32_t>(surface.positions.size());
        const Point& p = positions[corner];
        surface.positions.emplace_back(p[0], p[1], p[2]);
      }
      corner = id;
    }
    surface.triangles.push_back(corners);
  }
  return surface;
}

Surface Frame::to_unit(Surface surface) const {
  for (Vec3& p : surface.positions) p = to_unit(p);
  return surface;
}

Frame frame_of(const std::vector<Vec3>& points) {
  if (points.empty()) return {Vec3::Zero(), 0, 0};
  Vec3 lo = points[0], hi = points[0];
  for (const Vec3& p : points) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  return {(lo + hi) / 2, (hi - lo).maxCoeff(), (hi - lo).norm()};
}

}  // namespace filmsticking::mesh_report
