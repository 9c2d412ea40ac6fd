// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/winding_number.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace filmsticking {

std::vector<Vec3> film_dipoles(const Surface& film, std::size_t sites) {
  std::vector<Vec3> dipole(sites, Vec3::Zero());
  for (const Corners& t : film.triangles) {
    const Vec3 &a = film.positions[t[0]], &b = film.positions[t[1]], &c = film.positions[t[2]];
    const Vec3 third = (b - a).cross(c - a) / 6;
    for (Index v : t)
      if (film.site[v] != kNone && static_cast<std::size_t>(film.site[v]) < sites)
        dipole[film.site[v]] += third;
  }
  return dipole;
}

WindingNumber::WindingNumber(const std::vector<Vec3>& sites, const std::vector<Vec3>& dipoles) {
  for (std::size_t i = 0; i < sites.size(); ++i)
    if (dipoles[i].squaredNorm() > 0) position_.push_back(sites[i]), dipole_.push_back(dipoles[i]);
  if (!position_.empty()) build(0, static_cast<Index>(position_.size()));
}

Index WindingNumber::build(Index begin, Index end) {
  const Index n = static_cast<Index>(nodes_.size());
  nodes_.push_back({Vec3::Zero(), Vec3::Zero(), 0, begin, end, 0});
  double mass = 0;
  Vec3 centre = Vec3::Zero(), sum = Vec3::Zero();
  for (Index i = begin; i < end; ++i) {
    const double a = dipole_[i].norm();
    mass += a, centre += a * position_[i], sum += dipole_[i];
  }
  centre /= mass;
  double radius2 = 0;
  for (Index i = begin; i < end; ++i) radius2 = std::max(radius2, (position_[i] - centre).squaredNorm());
  if (end - begin > 8) {
    build(begin, begin + (end - begin) / 2);
    build(begin + (end - begin) / 2, end);
  }
  nodes_[n] = {centre, sum, radius2, begin, end, static_cast<Index>(nodes_.size())};
  return n;
}

double WindingNumber::operator()(const Vec3& x) const {
  // From 2.3 radii away a group counts as one dipole (Barill et al.).
  constexpr double kFar2 = 2.3 * 2.3;
  double sum = 0;
  for (Index n = 0; n < static_cast<Index>(nodes_.size());) {  // ends: `skip` is ahead
    const Node& node = nodes_[n];
    const Vec3 r = node.centre - x;
    const double r2 = r.squaredNorm();
    if (r2 > kFar2 * node.radius2 && node.end - node.begin > 1) {
      sum += node.dipole.dot(r) / (r2 * std::sqrt(r2));
      n = node.skip;
      continue;
    }
    if (node.skip == n + 1) {
      for (Index i = node.begin; i < node.end; ++i) {
        const Vec3 q = position_[i] - x;
        // A dipole stands for a disc: within the radius its field is bounded.
        const double q2 = q.squaredNorm() + dipole_[i].norm() / M_PI;
        sum += dipole_[i].dot(q) / (q2 * std::sqrt(q2));
      }
    }
    ++n;
  }
  return sum / (4 * M_PI);
}

}  // namespace filmsticking
