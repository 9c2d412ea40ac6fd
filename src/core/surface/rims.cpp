// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/rims.h"

#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "geometry/triangle_adjacency.h"

namespace filmsticking {
namespace {

// Walks along edges that were not walked before.
class Walk {
 public:
  explicit Walk(std::vector<RimEdge> edges) : edges_(std::move(edges)), done_(edges_.size(), 0) {
    std::sort(edges_.begin(), edges_.end());
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (const Index v : edges_[e]) at_[v].push_back(e);
  }

  std::vector<Rim> rims() {
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (!done_[e]) walk(e);
    for (Rim& rim : rims_) std::rotate(rim.begin(), std::min_element(rim.begin(), rim.end()), rim.end());
    std::sort(rims_.begin(), rims_.end());
    return std::move(rims_);
  }

 private:
  void walk(std::size_t edge) {
    Rim path{edges_[edge][0]};
    std::map<Index, std::size_t> place{{path[0], 0}};
    for (;;) {
      done_[edge] = 1;
      const Index v = edges_[edge][edges_[edge][0] == path.back() ? 1 : 0];
      if (const auto known = place.find(v); known != place.end()) {
        rims_.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(known->second), path.end());
        for (std::size_t k = known->second + 1; k < path.size(); ++k) place.erase(path[k]);
        path.resize(known->second + 1);
      } else {
        place[v] = path.size();
        path.push_back(v);
      }
      const std::size_t next = next_edge(path.back());
      if (next == edges_.size()) break;
      edge = next;
    }
    if (path.size() > 1) rims_.push_back(std::move(path));
  }

  // One that leaves, else one that comes; none: the number of edges.
  std::size_t next_edge(Index from) const {
    std::size_t found = edges_.size();
    for (const std::size_t e : at_.at(from))
      if (!done_[e] && (found == edges_.size() || (edges_[e][0] == from && edges_[found][0] != from)))
        found = e;
    return found;
  }

  std::vector<RimEdge> edges_;
  std::vector<char> done_;
  std::map<Index, std::vector<std::size_t>> at_;
  std::vector<Rim> rims_;
};

double ball_diameter(const std::vector<Vec3>& corners) {
  using Cartesian = CGAL::Simple_cartesian<double>;
  // The heuristic and not the other algorithm, which draws random numbers.
  using Traits = CGAL::Min_sphere_of_points_d_traits_3<Cartesian, double, CGAL::Tag_true,
                                                       CGAL::Farthest_first_heuristic>;
  std::vector<Cartesian::Point_3> points;
  for (const Vec3& p : corners) points.emplace_back(p.x(), p.y(), p.z());
  CGAL::Min_sphere_of_spheres_d<Traits> ball(points.begin(), points.end());
  return 2 * ball.radius();
}

// A power of two about as large as what the corners span: divided by it, no square overflows and none loses
// digits.
double span_of(const std::vector<Vec3>& corners) {
  double most = 0;
  for (const Vec3& p : corners) most = std::max(most, (p - corners[0]).lpNorm<Eigen::Infinity>());
  return most > 0 && std::isfinite(most) ? std::exp2(std::ilogb(most)) : 1;
}

Point point_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

std::vector<Rim> find_rims(std::vector<RimEdge> edges) { return Walk(std::move(edges)).rims(); }

std::vector<RimEdge> rim_edges(const std::vector<Corners>& triangles, const std::vector<Index>& twins) {
  std::vector<RimEdge> edges;
  const auto origin = [&](Index h) { return triangles[h / 3][h % 3]; };
  for (Index h = 0; h < static_cast<Index>(twins.size()); ++h)
    if (twins[h] == kNone) edges.push_back({origin(next_in_face(h)), origin(h)});
  return edges;
}

Hole measure_rim(const std::vector<Vec3>& corners) {
  Hole hole;
  hole.edges = static_cast<std::int64_t>(corners.size());
  if (corners.empty()) return hole;
  const double unit = span_of(corners);
  std::vector<Vec3> from_first;
  for (const Vec3& p : corners) from_first.push_back((p - corners[0]) / unit);
  Vec3 area = Vec3::Zero(), moment = Vec3::Zero();
  double length = 0;
  for (std::size_t i = 0; i < from_first.size(); ++i) {
    const Vec3 &a = from_first[i], &b = from_first[(i + 1) % from_first.size()];
    area += a.cross(b) / 2;
    length += (b - a).norm();
    moment += (b - a).norm() * (a + b) / 2;
  }
  hole.length = length * unit;
  hole.area = area.norm() * unit * unit;
  hole.normal = point_of(area.stableNormalized());
  hole.diameter = ball_diameter(from_first) * unit;
  hole.centre = point_of(length > 0 ? Vec3(corners[0] + moment / length * unit) : corners[0]);
  return hole;
}

}  // namespace filmsticking
