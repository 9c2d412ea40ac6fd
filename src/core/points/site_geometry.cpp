// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/site_geometry.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/nearest.h"
#include "geometry/parallel.h"
#include "geometry/quantile.h"

namespace filmsticking {
namespace {

// Least variance across a neighbourhood over that along it: the second axis over the first. A half disc, at a
// rim, has 0.28; points on a line have none.
constexpr double kSpan = 0.1;

/// A site's neighbours, itself first, and their covariance.
struct Neighbourhood {
  std::vector<Index> sites;
  double radius = 0;
  Vec3 mean = Vec3::Zero();
  Vec3 variance;  ///< along the axes, in rising order, in squared radii
  Vec3 normal;    ///< the first axis

  bool spans_a_surface() const { return variance[1] >= kSpan * variance[2]; }
};

Neighbourhood neighbourhood(const std::vector<Vec3>& sites, std::vector<Index> near) {
  Neighbourhood found;
  found.sites = std::move(near);
  found.radius = (sites[found.sites.back()] - sites[found.sites.front()]).norm();
  for (Index j : found.sites) found.mean += sites[j];
  found.mean /= static_cast<double>(found.sites.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (Index j : found.sites) covariance += (sites[j] - found.mean) * (sites[j] - found.mean).transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance / std::max(found.radius * found.radius, 1e-300));
  found.variance = solver.eigenvalues();
  found.normal = solver.eigenvectors().col(0);
  return found;
}

// The smallest that spans a surface.
Neighbourhood spanning_neighbourhood(const std::vector<Vec3>& sites, const NearestSites& nearest) {
  Neighbourhood first = neighbourhood(sites, nearest(kNeighbours + 1));
  if (first.spans_a_surface()) return first;
  for (std::size_t count = 2 * kNeighbours; count <= kMostNeighbours; count *= 2) {
    std::vector<Index> near = nearest(count + 1);
    if (near.size() <= count) break;
    Neighbourhood wider = neighbourhood(sites, std::move(near));
    if (wider.spans_a_surface()) return wider;
  }
  return first;
}

}  // namespace

SiteGeometry site_geometry(const std::vector<Vec3>& sites) {
  SiteGeometry geometry;
  geometry.spacing.assign(sites.size(), 0);
  geometry.radius.assign(sites.size(), 0);
  geometry.normal.assign(sites.size(), Vec3::UnitZ());
  geometry.near.resize(sites.size());
  geometry.variation.assign(sites.size(), 0);
  geometry.offset.assign(sites.size(), 0);
  const PointTree tree(sites);
  parallel_each(sites.size(), [&](std::size_t i) {
    describe_site(geometry, sites, static_cast<Index>(i),
                  [&](std::size_t count) { return tree.nearest(sites[i], count); });
  });
  return geometry;
}

void describe_site(SiteGeometry& geometry, const std::vector<Vec3>& sites, Index site,
                   const NearestSites& nearest) {
  const auto i = static_cast<std::size_t>(site);
  const Neighbourhood around = spanning_neighbourhood(sites, nearest);
  const std::vector<Index>& near = around.sites;
  const double n = static_cast<double>(near.size()) - 1, variance = around.variance.sum();
  geometry.radius[i] = around.radius;
  geometry.spacing[i] = around.radius * std::sqrt(M_PI / std::max(n, 1.0));
  for (std::size_t j = 0; j < 6; ++j) geometry.near[i][j] = j + 1 < near.size() ? near[j + 1] : kNone;
  // The spread of the n other points alone, from the n + 1 points around this mean.
  const double shift2 = (sites[i] - around.mean).squaredNorm();
  const double spread2 = variance * std::max(around.radius * around.radius, 1e-300) - shift2 * (n + 1) / n;
  geometry.offset[i] = spread2 > 0 ? (n + 1) / n * std::sqrt(shift2 * n / spread2) : 0;
  geometry.variation[i] = variance > 0 ? around.variance[0] / variance : 0;
  const bool sure = around.normal.allFinite() && around.normal.squaredNorm() > 0.5;
  geometry.normal[i] = sure ? around.normal : Vec3::UnitZ();
}

double near_spacing(const SiteGeometry& geometry, Index site) {
  std::array<double, 6> spacing;
  std::size_t count = 0;
  for (Index other : geometry.near[site])
    if (other != kNone) spacing[count++] = geometry.spacing[other];
  if (count == 0) return geometry.spacing[site];
  return median(spacing.begin(), spacing.begin() + count);
}

}  // namespace filmsticking
