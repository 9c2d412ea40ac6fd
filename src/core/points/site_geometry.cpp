// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/site_geometry.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "geometry/nearest.h"
#include "geometry/parallel.h"
#include "geometry/quantile.h"

namespace filmsticking {

SiteGeometry site_geometry(const std::vector<Vec3>& sites) {
  SiteGeometry geometry;
  geometry.spacing.assign(sites.size(), 0);
  geometry.normal.assign(sites.size(), Vec3::UnitZ());
  geometry.near.resize(sites.size());
  geometry.variation.assign(sites.size(), 0);
  geometry.offset.assign(sites.size(), 0);
  const PointTree tree(sites);
  parallel_each(sites.size(), [&](std::size_t i) {
    describe_site(geometry, sites, static_cast<Index>(i), tree.nearest(sites[i], kNeighbours + 1));
  });
  return geometry;
}

void describe_site(SiteGeometry& geometry, const std::vector<Vec3>& sites, Index site,
                   const std::vector<Index>& near) {
  const auto i = static_cast<std::size_t>(site);
  const double radius = (sites[near.back()] - sites[i]).norm();
  geometry.spacing[i] =
      radius * std::sqrt(M_PI / static_cast<double>(std::max<std::size_t>(near.size() - 1, 1)));
  for (std::size_t j = 0; j < 6; ++j) geometry.near[i][j] = j + 1 < near.size() ? near[j + 1] : kNone;
  Vec3 mean = Vec3::Zero();
  for (Index j : near) mean += sites[j];
  mean /= static_cast<double>(near.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (Index j : near) covariance += (sites[j] - mean) * (sites[j] - mean).transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance / std::max(radius * radius, 1e-300));
  // The spread of the n other points alone, from the n + 1 points around this mean.
  const double n = static_cast<double>(near.size()) - 1, shift2 = (sites[i] - mean).squaredNorm();
  const double spread2 = covariance.trace() - shift2 * (n + 1) / n;
  geometry.offset[i] = spread2 > 0 ? (n + 1) / n * std::sqrt(shift2 * n / spread2) : 0;
  const double variance = solver.eigenvalues().sum();
  geometry.variation[i] = variance > 0 ? solver.eigenvalues()[0] / variance : 0;
  const Vec3 normal = solver.eigenvectors().col(0);
  geometry.normal[i] = normal.allFinite() && normal.squaredNorm() > 0.5 ? normal : Vec3::UnitZ();
}

double neighbour_radius(const SiteGeometry& geometry, Index site) {
  return geometry.spacing[site] / std::sqrt(M_PI / static_cast<double>(kNeighbours));
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
