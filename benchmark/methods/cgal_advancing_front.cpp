// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Advancing_front_surface_reconstruction.h>

#include <array>

#include "cgal_points.h"
#include "peers.h"

namespace filmsticking::bench {

Outcome run_cgal_advancing_front(const std::vector<Point>& points, int) {
  Stopwatch watch;
  const std::vector<Kernel::Point_3> sites = to_cgal(points);
  std::vector<std::array<std::size_t, 3>> facets;
  CGAL::advancing_front_surface_reconstruction(sites.begin(), sites.end(), std::back_inserter(facets));
  Outcome outcome;
  outcome.mesh = {points, to_triangles(facets)};
  outcome.seconds = watch.lap();
  return outcome;
}

}  // namespace filmsticking::bench
