// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::bench {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline std::vector<Kernel::Point_3> to_cgal(const std::vector<Point>& points) {
  std::vector<Kernel::Point_3> all;
  all.reserve(points.size());
  for (const Point& p : points) all.emplace_back(p[0], p[1], p[2]);
  return all;
}

/// Triangles of any three indices.
template <class Facets>
std::vector<Triangle> to_triangles(const Facets& facets) {
  std::vector<Triangle> triangles;
  for (const auto& f : facets)
    triangles.push_back(
        {static_cast<std::int32_t>(f[0]), static_cast<std::int32_t>(f[1]), static_cast<std::int32_t>(f[2])});
  return triangles;
}

}  // namespace filmsticking::bench
