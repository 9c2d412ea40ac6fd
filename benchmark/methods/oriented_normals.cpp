// SPDX-License-Identifier: GPL-3.0-or-later
#include "oriented_normals.h"

#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cgal_points.h"

namespace filmsticking::bench {

std::vector<Point> oriented_normals(const std::vector<Point>& points) {
  constexpr unsigned kNeighbours = 18;  // as in the library's examples
  const std::vector<Kernel::Point_3> sites = to_cgal(points);
  std::vector<Kernel::Vector_3> normals(sites.size());
  std::vector<std::size_t> order(
      sites.size());  // mst_orient_normals moves normals that it cannot orient to the end
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto parameters = CGAL::parameters::point_map(CGAL::make_property_map(sites))
                              .normal_map(CGAL::make_property_map(normals));
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(order, kNeighbours, parameters);
  CGAL::mst_orient_normals(order, kNeighbours, parameters);
  std::vector<Point> out;
  out.reserve(normals.size());
  for (const Kernel::Vector_3& n : normals) out.push_back({n.x(), n.y(), n.z()});
  return out;
}

int poisson_depth(std::size_t points) {
  const int depth = static_cast<int>(std::ceil(std::log2(std::sqrt(static_cast<double>(points))))) + 1;
  return std::clamp(depth, 5, 12);
}

}  // namespace filmsticking::bench
