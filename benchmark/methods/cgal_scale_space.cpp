// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Scale_space_reconstruction_3/Advancing_front_mesher.h>
#include <CGAL/Scale_space_surface_reconstruction_3.h>

#include "cgal_points.h"
#include "peers.h"

namespace filmsticking::bench {

Outcome run_cgal_scale_space(const std::vector<Point>& points, int) {
  constexpr std::size_t kSteps = 4;  // as in the library's examples
  Stopwatch watch;
  const std::vector<Kernel::Point_3> sites = to_cgal(points);
  CGAL::Scale_space_surface_reconstruction_3<Kernel> reconstruction(sites.begin(), sites.end());
  reconstruction.increase_scale(kSteps);
  // The default mesher takes an alpha shape, which is no manifold; this is the manual's other one.
  reconstruction.reconstruct_surface(CGAL::Scale_space_reconstruction_3::Advancing_front_mesher<Kernel>());
  Outcome outcome;
  // The surface at the original points, not at the smoothed ones: the method interpolates.
  outcome.mesh.positions = points;
  for (auto facet = reconstruction.facets_begin(); facet != reconstruction.facets_end(); ++facet)
    outcome.mesh.triangles.push_back({static_cast<std::int32_t>((*facet)[0]),
                                      static_cast<std::int32_t>((*facet)[1]),
                                      static_cast<std::int32_t>((*facet)[2])});
  outcome.seconds = watch.lap();
  return outcome;
}

}  // namespace filmsticking::bench
