// SPDX-License-Identifier: GPL-3.0-or-later
#include "self_intersections.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <atomic>
#include <vector>

namespace filmsticking::mesh_report {
namespace {

using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point3 = ExactKernel::Point_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

/// Thrown to end the search.
struct Enough {};

class Faces {
 public:
  explicit Faces(const Surface& surface) : triangles_(surface.triangles) {
    points_.reserve(surface.positions.size());
    for (const Vec3& p : surface.positions) points_.emplace_back(p.x(), p.y(), p.z());
  }

  std::vector<Box> boxes() const {
    std::vector<Box> boxes;
    boxes.reserve(triangles_.size());
    for (std::size_t f = 0; f < triangles_.size(); ++f) boxes.emplace_back(triangle(f).bbox(), f);
    return boxes;
  }

  bool intersect(std::size_t f, std::size_t g) const {
    const Triangle &s = triangles_[f], &t = triangles_[g];
    const auto shared_by = [](const Triangle& face) {
      return [&face](std::int32_t v) { return std::find(face.begin(), face.end(), v) != face.end(); };
    };
    const auto shared = std::count_if(s.begin(), s.end(), shared_by(t));
    if (shared == 3) return true;
    if (flat(s) || flat(t)) return false;
    if (shared == 0) return CGAL::do_intersect(triangle(f), triangle(g));
    if (shared == 1) {
      // The faces have a corner in common, so they meet elsewhere where a side that lacks it meets the other.
      const auto i = std::find_if(s.begin(), s.end(), shared_by(t)) - s.begin();
      const auto j = std::find_if(t.begin(), t.end(), shared_by(s)) - t.begin();
      return CGAL::do_intersect(triangle(g), side(s, i + 1)) ||
             CGAL::do_intersect(triangle(f), side(t, j + 1));
    }
    // Across a common edge only faces folded onto each other meet elsewhere.
    const auto i = std::find_if_not(s.begin(), s.end(), shared_by(t)) - s.begin();
    const auto j = std::find_if_not(t.begin(), t.end(), shared_by(s)) - t.begin();
    const Point3 &a = point(s, i + 1), &b = point(s, i + 2), &c = point(s, i), &d = point(t, j);
    return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
  }

 private:
  const Point3& point(const Triangle& t, std::ptrdiff_t k) const { return points_[t[k % 3]]; }
  ExactKernel::Segment_3 side(const Triangle& t, std::ptrdiff_t k) const {
    return {point(t, k), point(t, k + 1)};
  }
  bool flat(const Triangle& t) const { return CGAL::collinear(point(t, 0), point(t, 1), point(t, 2)); }
  ExactKernel::Triangle_3 triangle(std::size_t f) const {
    const Triangle& t = triangles_[f];
    return {point(t, 0), point(t, 1), point(t, 2)};
  }

  const std::vector<Triangle>& triangles_;
  std::vector<Point3> points_;
};

}  // namespace

SelfIntersections self_intersections(const Surface& surface) {
  const Faces faces(surface);
  std::vector<Box> boxes = faces.boxes();
  std::atomic<std::int64_t> pairs{0};
  std::vector<std::atomic<char>> meets(surface.triangles.size());
  const auto count = [&](const Box& x, const Box& y) {
    if (!faces.intersect(x.info(), y.info())) return;
    meets[x.info()].store(1, std::memory_order_relaxed);
    meets[y.info()].store(1, std::memory_order_relaxed);
    if (++pairs >= kMostIntersections) throw Enough{};
  };
  try {
    CGAL::box_self_intersection_d<CGAL::Parallel_tag>(boxes.begin(), boxes.end(), count);
  } catch (const Enough&) {
  }
  return {std::min(pairs.load(), kMostIntersections), {meets.begin(), meets.end()}};
}

}  // namespace filmsticking::mesh_report
