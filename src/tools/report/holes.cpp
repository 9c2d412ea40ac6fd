// SPDX-License-Identifier: GPL-3.0-or-later
#include "holes.h"

#include <CGAL/Cartesian.h>
#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace filmsticking::mesh_report {
namespace {

/// The edges with one face as a graph.
class Rims {
 public:
  Rims(const Surface& surface, const std::vector<Side>& sides) : edges_at_(surface.positions.size()) {
    for (auto begin = sides.begin(); begin != sides.end();) {
      const auto end =
          std::find_if(begin, sides.end(), [&](const Side& side) { return !side.same_edge(*begin); });
      if (end - begin == 1) add(begin->end(), begin->begin());
      begin = end;
    }
  }

  /// Loops without a repeated vertex; what is left of a chain that does not close is one too.
  std::vector<std::vector<std::int32_t>> loops() {
    std::vector<std::vector<std::int32_t>> loops;
    std::vector<std::int32_t> place(edges_at_.size(), -1);  // on the path
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (used_[e]) continue;
      std::vector<std::int32_t> path;
      std::int32_t vertex = edges_[e].first;
      while (vertex >= 0) {
        if (place[vertex] >= 0) {
          const auto loop = path.begin() + place[vertex];
          loops.emplace_back(loop, path.end());
          for (auto v = loop; v != path.end(); ++v) place[*v] = -1;
          path.erase(loop, path.end());
        }
        place[vertex] = static_cast<std::int32_t>(path.size());
        path.push_back(vertex);
        vertex = step(vertex);
      }
      for (const std::int32_t v : path) place[v] = -1;
      if (path.size() > 1) loops.push_back(std::move(path));
    }
    return loops;
  }

 private:
  void add(std::int32_t from, std::int32_t to) {
    edges_at_[from].push_back(static_cast<std::int32_t>(edges_.size()));
    edges_at_[to].push_back(static_cast<std::int32_t>(edges_.size()));
    edges_.emplace_back(from, to);
    used_.push_back(0);
  }

  /// The other end of an edge that is not used yet, first of those that leave the vertex; -1: none.
  std::int32_t step(std::int32_t vertex) {
    std::int32_t best = -1;
    for (const std::int32_t e : edges_at_[vertex])
      if (!used_[e] && (best < 0 || (edges_[e].first == vertex && edges_[best].first != vertex))) best = e;
    if (best < 0) return -1;
    used_[best] = 1;
    return edges_[best].first == vertex ? edges_[best].second : edges_[best].first;
  }

  std::vector<std::pair<std::int32_t, std::int32_t>> edges_;  // as a lid would run along them
  std::vector<char> used_;
  std::vector<std::vector<std::int32_t>> edges_at_;
};

Hole measure(const Surface& surface, std::vector<std::int32_t> vertices) {
  using Kernel = CGAL::Cartesian<double>;
  using Traits = CGAL::Min_sphere_of_points_d_traits_3<Kernel, double>;
  Hole hole;
  std::vector<Vec3> corners;
  for (const std::int32_t v : vertices) corners.push_back(surface.positions[v]);
  const Frame frame = frame_of(corners);  // in the unit box, where no square overflows
  std::vector<Kernel::Point_3> points;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3 a = frame.to_unit(corners[k]), b = frame.to_unit(corners[(k + 1) % corners.size()]);
    points.emplace_back(a.x(), a.y(), a.z());
    hole.length += (b - a).norm() * frame.side;
    hole.area_vector += a.cross(b) / 2 * frame.side * frame.side;
  }
  CGAL::Min_sphere_of_spheres_d<Traits> ball(points.begin(), points.end());
  hole.diameter = 2 * ball.radius() * frame.side;
  const auto centre = ball.center_cartesian_begin();
  hole.centre = frame.centre + Vec3(centre[0], centre[1], centre[2]) * frame.side;
  hole.vertices = std::move(vertices);
  return hole;
}

}  // namespace

std::vector<Hole> holes(const Surface& surface, const std::vector<Side>& sides) {
  std::vector<Hole> holes;
  for (std::vector<std::int32_t>& loop : Rims(surface, sides).loops())
    holes.push_back(measure(surface, std::move(loop)));
  std::stable_sort(holes.begin(), holes.end(),
                   [](const Hole& a, const Hole& b) { return a.diameter > b.diameter; });
  return holes;
}

}  // namespace filmsticking::mesh_report
