// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_distance.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace filmsticking::mesh_report {
namespace {

using TreeKernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<TreeKernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<TreeKernel, Triangles::const_iterator>;

TreeKernel::Point_3 cgal_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// A face on one line becomes its longest side, there and back: of three distinct corners on a line CGAL 5.5
/// takes any two.
TreeKernel::Triangle_3 cgal_triangle(const Surface& surface, std::size_t f) {
  constexpr double kOnOneLine = 1e-14;  // height over length
  int longest = 0;
  double length2 = 0;
  for (int k = 0; k < 3; ++k) {
    const double side2 = (surface.corner(f, (k + 1) % 3) - surface.corner(f, k)).squaredNorm();
    if (side2 > length2) longest = k, length2 = side2;
  }
  const TreeKernel::Point_3 a = cgal_point(surface.corner(f, longest)),
                            b = cgal_point(surface.corner(f, (longest + 1) % 3)),
                            c = cgal_point(surface.corner(f, (longest + 2) % 3));
  const bool on_one_line = surface.area_vector2(f).norm() <= kOnOneLine * length2;
  return {a, b, on_one_line ? a : c};
}

}  // namespace

struct SurfaceDistance::Tree {
  Triangles triangles;
  CGAL::AABB_tree<CGAL::AABB_traits<TreeKernel, Primitive>> boxes;
};

SurfaceDistance::SurfaceDistance(const Surface& surface) : tree_(new Tree) {
  Triangles& triangles = tree_->triangles;
  triangles.reserve(surface.triangles.size());
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) triangles.push_back(cgal_triangle(surface, f));
  tree_->boxes.insert(triangles.cbegin(), triangles.cend());
  tree_->boxes.build();
  // Before the first query: queries run in several threads.
  tree_->boxes.accelerate_distance_queries();
}

SurfaceDistance::~SurfaceDistance() = default;

std::vector<Nearest> SurfaceDistance::from(const std::vector<Vec3>& points) const {
  std::vector<Nearest> nearest(points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const TreeKernel::Point_3 p = cgal_point(points[i]);
      const auto hit = tree_->boxes.closest_point_and_primitive(p);
      nearest[i] = {std::sqrt(CGAL::squared_distance(p, hit.first)),
                    static_cast<std::size_t>(hit.second - tree_->triangles.cbegin())};
    }
  });
  return nearest;
}

}  // namespace filmsticking::mesh_report
