// SPDX-License-Identifier: GPL-3.0-or-later
#include "cloud_fit.h"

#include <algorithm>
#include <numeric>

#include "point_distance.h"
#include "surface_distance.h"

namespace filmsticking::mesh_report {
namespace {

constexpr double kSamePlace = 1e-7;  // of the diagonal

std::vector<Vec3> distinct(std::vector<Point> points) {
  points.erase(std::remove_if(points.begin(), points.end(), [](const Point& p) { return !usable(p); }),
               points.end());
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Point& p : points) result.emplace_back(p[0], p[1], p[2]);
  return result;
}

}  // namespace

CloudDistances cloud_distances(const Surface& mesh, const std::vector<Point>& cloud) {
  CloudDistances result{distinct(cloud), {}};
  if (result.points.empty() || mesh.triangles.empty()) return result;
  // In the unit box: large coordinates would cost digits.
  const Frame frame = frame_of(result.points);
  const Surface surface = frame.to_unit(mesh);
  std::vector<Vec3> points = result.points;
  for (Vec3& p : points) p = frame.to_unit(p);
  for (const Nearest& nearest : SurfaceDistance(surface).from(points))
    result.to_mesh.push_back(nearest.distance * (frame.side > 0 ? frame.side : 1));
  return result;
}

CloudFit cloud_fit_of(const Surface& mesh, const CloudDistances& distances) {
  const std::vector<Vec3>& points = distances.points;
  CloudFit fit;
  fit.points = static_cast<std::int64_t>(points.size());
  if (distances.to_mesh.empty()) return fit;
  const double reach = kSamePlace * frame_of(points).diagonal, count = static_cast<double>(points.size());
  const std::vector<double> to_vertex = PointDistance(mesh.positions).from(points);
  const auto near = std::count_if(to_vertex.begin(), to_vertex.end(), [&](double d) { return d <= reach; });
  fit.interpolated = 100 * static_cast<double>(near) / count;
  fit.distance_mean = std::accumulate(distances.to_mesh.begin(), distances.to_mesh.end(), 0.0) / count;
  fit.distance_max = *std::max_element(distances.to_mesh.begin(), distances.to_mesh.end());
  return fit;
}

}  // namespace filmsticking::mesh_report
