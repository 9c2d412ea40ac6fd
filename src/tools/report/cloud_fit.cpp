// SPDX-License-Identifier: GPL-3.0-or-later
#include "cloud_fit.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

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

/// How many of the points have one of the places within `reach`.
std::int64_t count_near(const std::vector<Vec3>& points, const std::vector<Vec3>& places, double reach) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;
  if (places.empty()) return 0;
  const auto cgal_point = [](const Vec3& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
  Search::Tree tree;
  tree.reserve(places.size());
  for (const Vec3& p : places) tree.insert(cgal_point(p));
  tree.build();  // before the first query: queries run in several threads
  std::atomic<std::int64_t> near{0};
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 256), [&](const auto& range) {
    std::int64_t here = 0;
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const Search search(tree, cgal_point(points[i]), 1);
      if (search.begin()->second <= reach * reach) ++here;
    }
    near += here;
  });
  return near;
}

}  // namespace

CloudFit cloud_fit(const Surface& mesh, const std::vector<Point>& cloud) {
  std::vector<Vec3> points = distinct(cloud);
  CloudFit fit;
  fit.points = static_cast<std::int64_t>(points.size());
  if (points.empty() || mesh.triangles.empty()) return fit;

  // In the unit box: large coordinates would cost digits.
  const Frame frame = frame_of(points);
  const double unit = frame.side > 0 ? frame.side : 1;
  const Surface surface = frame.to_unit(mesh);
  for (Vec3& p : points) p = frame.to_unit(p);

  const std::int64_t near = count_near(points, surface.positions, kSamePlace * frame.diagonal / unit);
  fit.interpolated = 100 * static_cast<double>(near) / static_cast<double>(points.size());
  double sum = 0, most = 0;
  for (const Nearest& nearest : SurfaceDistance(surface).from(points)) {
    sum += nearest.distance;
    most = std::max(most, nearest.distance);
  }
  fit.distance_mean = sum / static_cast<double>(points.size()) * unit;
  fit.distance_max = most * unit;
  return fit;
}

}  // namespace filmsticking::mesh_report
