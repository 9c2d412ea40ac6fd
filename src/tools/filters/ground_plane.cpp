// SPDX-License-Identifier: GPL-3.0-or-later
#include "ground_plane.h"

#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>

#include "filter_error.h"
#include "filter_options.h"

namespace filmsticking::filters {
namespace {

constexpr std::size_t kMostForSearch = 100'000;  // of RANSAC; every nth of more points
constexpr std::size_t kMostForSpacing = 2'000;
constexpr double kLeastShare = 0.05;  // of the points on the plane

Eigen::Vector3d vec3(const Point& p) { return {p[0], p[1], p[2]}; }

bool finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

/// A cloud in its unit box, so that single precision keeps the digits of far points.
struct UnitCloud {
  pcl::PointCloud<pcl::PointXYZ>::Ptr points =
      pcl::PointCloud<pcl::PointXYZ>::Ptr(new pcl::PointCloud<pcl::PointXYZ>);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double side = 0;

  UnitCloud(const std::vector<Point>& given, std::size_t most) {
    Eigen::Vector3d least = Eigen::Vector3d::Constant(INFINITY), greatest = -least;
    std::size_t count = 0;
    for (const Point& p : given) {
      if (!finite(p)) continue;
      least = least.cwiseMin(vec3(p));
      greatest = greatest.cwiseMax(vec3(p));
      ++count;
    }
    if (count == 0) return;
    middle = least / 2 + greatest / 2;
    side = (greatest - least).maxCoeff();
    if (!(side > 0) || !std::isfinite(side)) return;
    const std::size_t stride = (count - 1) / most + 1;
    std::size_t at = 0;
    for (const Point& p : given)
      if (finite(p) && at++ % stride == 0) {
        const Eigen::Vector3f unit = ((vec3(p) - middle) / side).cast<float>();
        points->push_back({unit.x(), unit.y(), unit.z()});
      }
  }
};

/// By least squares through the points within `reach`.
GroundPlane fitted(const std::vector<Point>& points, const GroundPlane& plane, double reach) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> near;
  for (const Point& p : points)
    if (finite(p) && std::abs(plane.height(vec3(p))) <= reach) {
      near.push_back(vec3(p));
      sum += near.back();
    }
  if (near.size() < 3) return plane;
  const Eigen::Vector3d middle = sum / static_cast<double>(near.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : near) spread += (p - middle) * (p - middle).transpose();
  GroundPlane result;
  result.up = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  if (result.up.dot(plane.up) < 0) result.up = -result.up;
  result.offset = -result.up.dot(middle);
  return result;
}

std::vector<double> heights_of(const std::vector<Point>& points, const GroundPlane& plane) {
  std::vector<double> heights;
  for (const Point& p : points)
    if (finite(p)) heights.push_back(plane.height(vec3(p)));
  return heights;
}

}  // namespace

GroundChoice parse_ground(const std::string& text) {
  if (text == "auto") return {true, std::nullopt};
  const std::vector<double> numbers = parse_numbers(text);
  if (numbers.size() == 4) {
    const Eigen::Vector3d direction(numbers[0], numbers[1], numbers[2]);
    const double length = direction.stableNorm();
    if (length > 0 && std::isfinite(numbers[3] / length))
      return {true, GroundPlane{direction / length, numbers[3] / length}};
  }
  throw FilterError("ground takes A,B,C,D, the plane Ax + By + Cz + D = 0 with (A, B, C) pointing up, not '" +
                    text + "'");
}

double usual_distance(const std::vector<Point>& points) {
  std::vector<Point> distinct;
  std::copy_if(points.begin(), points.end(), std::back_inserter(distinct), finite);
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  const UnitCloud cloud(distinct, SIZE_MAX);
  if (cloud.points->size() < 2) return 0;
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud.points);
  std::vector<float> distances;
  const std::size_t stride = (cloud.points->size() - 1) / kMostForSpacing + 1;
  for (std::size_t i = 0; i < cloud.points->size(); i += stride) {
    std::vector<int> nearest;
    std::vector<float> squares;
    tree.nearestKSearch((*cloud.points)[i], 8, nearest, squares);
    const auto other = std::find_if(squares.begin(), squares.end(), [](float d) { return d > 0; });
    if (other != squares.end()) distances.push_back(std::sqrt(*other));
  }
  if (distances.empty()) return 0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return static_cast<double>(*middle) * cloud.side;
}

GroundPlane find_ground(const std::vector<Point>& points) {
  const UnitCloud cloud(points, kMostForSearch);
  const double reach = 2 * usual_distance(points);
  if (cloud.points->size() < 3 || !(reach > 0))
    throw FilterError("ground: there are too few points for a plane");

  pcl::SACSegmentation<pcl::PointXYZ> search;  // its random numbers are the same each time
  search.setModelType(pcl::SACMODEL_PLANE);
  search.setMethodType(pcl::SAC_RANSAC);
  search.setMaxIterations(1000);
  search.setDistanceThreshold(reach / cloud.side);
  search.setOptimizeCoefficients(true);
  search.setInputCloud(cloud.points);
  pcl::PointIndices inliers;
  pcl::ModelCoefficients model;
  search.segment(inliers, model);
  if (model.values.size() != 4 ||
      static_cast<double>(inliers.indices.size()) < kLeastShare * static_cast<double>(cloud.points->size()))
    throw FilterError("ground: no plane has a twentieth of the points; say which it is by --ground A,B,C,D");

  GroundPlane plane;
  plane.up = Eigen::Vector3d(model.values[0], model.values[1], model.values[2]).normalized();
  plane.offset = static_cast<double>(model.values[3]) * cloud.side - plane.up.dot(cloud.middle);
  plane = fitted(points, plane, reach);
  plane = fitted(points, plane, std::max(3 * ground_noise(heights_of(points, plane), reach), reach / 8));
  std::int64_t above = 0, below = 0;
  for (const double height : heights_of(points, plane)) {
    above += height > reach ? 1 : 0;
    below += height < -reach ? 1 : 0;
  }
  if (below > above) {
    plane.up = -plane.up;
    plane.offset = -plane.offset;
  }
  return plane;
}

double ground_noise(const std::vector<double>& heights, double reach) {
  std::vector<double> near;
  for (const double height : heights)
    if (height < 0 && height >= -reach) near.push_back(-height);
  if (near.empty()) return 0;
  const auto middle = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 2);
  std::nth_element(near.begin(), middle, near.end());
  return 1.4826 * *middle;  // of the normal distribution
}

std::string to_text(const GroundPlane& plane) {
  char text[160];
  std::snprintf(text, sizeof text, "%.6f x %+.6f y %+.6f z %+.6g = 0", plane.up.x(), plane.up.y(),
                plane.up.z(), plane.offset);
  return text;
}

}  // namespace filmsticking::filters
