// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include "cgal_points.h"
#include "peers.h"
#include "spacing.h"

namespace filmsticking::bench {

Outcome run_cgal_alpha_wrap(const std::vector<Point>& points, int) {
  // The smallest alpha that closes the holes between random samples, and an offset too small to be seen.
  constexpr double kAlphaSpacings = 3, kAlphaOverOffset = 100;
  Outcome outcome;
  Stopwatch watch;
  const double alpha = kAlphaSpacings * mean_spacing(points);
  outcome.needs_seconds = watch.lap();
  CGAL::Surface_mesh<Kernel::Point_3> wrap;
  CGAL::alpha_wrap_3(to_cgal(points), alpha, alpha / kAlphaOverOffset, wrap);
  for (const auto vertex : wrap.vertices()) {
    const Kernel::Point_3& p = wrap.point(vertex);
    outcome.mesh.positions.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto face : wrap.faces()) {
    Triangle triangle{};
    int k = 0;
    for (const auto vertex : wrap.vertices_around_face(wrap.halfedge(face)))
      triangle[k++] = static_cast<std::int32_t>(vertex.idx());
    outcome.mesh.triangles.push_back(triangle);
  }
  outcome.seconds = watch.lap();
  return outcome;
}

}  // namespace filmsticking::bench
