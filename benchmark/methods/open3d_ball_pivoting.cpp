// SPDX-License-Identifier: GPL-3.0-or-later
#include "open3d_cloud.h"
#include "peers.h"
#include "spacing.h"

namespace filmsticking::bench {

Outcome run_open3d_ball_pivoting(const std::vector<Point>& points, int) {
  Outcome outcome;
  Stopwatch watch;
  const auto cloud = open3d_with_normals(points);
  const double spacing = mean_spacing(points);
  outcome.needs_seconds = watch.lap();
  const auto mesh = open3d::geometry::TriangleMesh::CreateFromPointCloudBallPivoting(
      cloud, {spacing, 2 * spacing, 4 * spacing});
  outcome.mesh = from_open3d(*mesh);
  outcome.seconds = watch.lap();
  return outcome;
}

}  // namespace filmsticking::bench
