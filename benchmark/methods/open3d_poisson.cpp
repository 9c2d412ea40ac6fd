// SPDX-License-Identifier: GPL-3.0-or-later
#include "open3d_cloud.h"
#include "peers.h"

namespace filmsticking::bench {

Outcome run_open3d_poisson(const std::vector<Point>& points, int threads) {
  Outcome outcome;
  Stopwatch watch;
  const auto cloud = open3d_with_normals(points);
  outcome.needs_seconds = watch.lap();
  const auto [mesh, densities] = open3d::geometry::TriangleMesh::CreateFromPointCloudPoisson(
      cloud, static_cast<std::size_t>(poisson_depth(points.size())), 0, 1.1F, false,
      threads > 0 ? threads : -1);
  outcome.mesh = from_open3d(*mesh);
  outcome.seconds = watch.lap();
  return outcome;
}

}  // namespace filmsticking::bench
