// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/surface/poisson.h>

#include <Eigen/Core>
#include <thread>

#include "oriented_normals.h"
#include "pcl_cloud.h"
#include "pcl_normals.h"
#include "peers.h"

namespace filmsticking::bench {

namespace {

Outcome run(const pcl::PointCloud<pcl::PointNormal>::Ptr& cloud, double needs_seconds, int threads) {
  Outcome outcome;
  outcome.needs_seconds = needs_seconds;
  Stopwatch watch;
  pcl::Poisson<pcl::PointNormal> poisson;
  poisson.setInputCloud(cloud);
  poisson.setDepth(poisson_depth(cloud->size()));
  poisson.setThreads(threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency()));
  pcl::PointCloud<pcl::PointNormal> vertices;
  std::vector<pcl::Vertices> polygons;
  poisson.reconstruct(vertices, polygons);
  for (const pcl::PointNormal& p : vertices) outcome.mesh.positions.push_back({p.x, p.y, p.z});
  outcome.mesh.triangles = to_triangles(polygons);
  outcome.seconds = watch.lap();
  return outcome;
}

}  // namespace

Outcome run_pcl_poisson(const std::vector<Point>& points, int threads) {
  Stopwatch watch;
  const auto cloud = with_normals(points, oriented_normals(points));
  return run(cloud, watch.lap(), threads);
}

Outcome run_pcl_poisson_sight(const SeenCloud& cloud, int threads) {
  Stopwatch watch;
  std::vector<Point> normals = pcl_normals(cloud.points);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    Eigen::Vector3d to_sensor;
    for (int k = 0; k < 3; ++k)
      to_sensor[k] =
          cloud.sensors.empty() ? -(*cloud.direction)[k] : cloud.sensors[i][k] - cloud.points[i][k];
    Eigen::Map<Eigen::Vector3d> normal(normals[i].data());
    if (normal.dot(to_sensor) < 0) normal = -normal;
  }
  const auto with = with_normals(cloud.points, normals);
  return run(with, watch.lap(), threads);
}

}  // namespace filmsticking::bench
