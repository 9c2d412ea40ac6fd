// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Delaunay_triangulation_3.h>

#include <stdexcept>

#include "cgal_points.h"
#include "peers.h"

namespace filmsticking::bench {

Outcome run_delaunay(const std::vector<Point>& points, int) {
  Stopwatch watch;
  const std::vector<Kernel::Point_3> sites = to_cgal(points);
  const CGAL::Delaunay_triangulation_3<Kernel> triangulation(sites.begin(), sites.end());
  Outcome outcome;
  outcome.seconds = watch.lap();
  if (triangulation.dimension() < 3) throw std::runtime_error("the points lie on one plane");
  return outcome;
}

}  // namespace filmsticking::bench
