// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/surface/poisson.h>

#include <thread>

#include "pcl_cloud.h"
#include "peers.h"

namespace filmsticking::bench {

Outcome run_pcl_poisson(const std::vector<Point>& points, int threads) {
  Outcome outcome;
  Stopwatch watch;
  const auto cloud = with_normals(points);
  outcome.needs_seconds = watch.lap();

  pcl::Poisson<pcl::PointNormal> poisson;
  poisson.setInputCloud(cloud);
  poisson.setDepth(poisson_depth(points.size()));
  poisson.setThreads(threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency()));
  pcl::PointCloud<pcl::PointNormal> vertices;
  std::vector<pcl::Vertices> polygons;
  poisson.reconstruct(vertices, polygons);
  for (const pcl::PointNormal& p : vertices) outcome.mesh.positions.push_back({p.x, p.y, p.z});
  outcome.mesh.triangles = to_triangles(polygons);
  outcome.seconds = watch.lap();
  return outcome;
}

}  // namespace filmsticking::bench
