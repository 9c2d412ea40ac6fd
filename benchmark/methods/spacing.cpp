// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacing.h"

#include <CGAL/compute_average_spacing.h>

#include "cgal_points.h"

namespace filmsticking::bench {

double mean_spacing(const std::vector<Point>& points) {
  constexpr unsigned kNeighbours = 6;
  return CGAL::compute_average_spacing<CGAL::Sequential_tag>(to_cgal(points), kNeighbours);
}

}  // namespace filmsticking::bench
