// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/winding_number.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/surface_normals.h"

namespace filmsticking {
namespace {

// From 2.3 radii away a group counts as one dipole (Barill et al.).
constexpr double kFar2 = 2.3 * 2.3;
// Faces of a group that is not divided.
constexpr Index kFewFaces = 4;

}  // namespace

std::vector<Vec3> film_dipoles(const Surface& film, const std::vector<double>& spacing) {
  std::vector<Vec3> dipole = surface_normals(film, std::vector<Vec3>(spacing.size(), Vec3::Zero()));
  for (std::size_t s = 0; s < spacing.size(); ++s) dipole[s] *= spacing[s] * spacing[s];
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

SurfaceWinding::SurfaceWinding(Surface surface) : surface_(std::move(surface)) {
  if (!surface_.triangles.empty()) build(0, static_cast<Index>(surface_.triangles.size()));
}

Index SurfaceWinding::build(Index begin, Index end) {
  const auto n = static_cast<Index>(nodes_.size());
  nodes_.emplace_back();
  Node node;
  node.begin = begin, node.end = end;
  Eigen::AlignedBox3d box;
  for (Index i = begin; i < end; ++i) {
    node.dipole += surface_.area_vector2(i) / 2;
    for (int k = 0; k < 3; ++k) box.extend(surface_.corner(i, k));
  }
  node.centre = box.center();
  node.radius2 = box.diagonal().squaredNorm() / 4;
  if (end - begin > kFewFaces) {
    build(begin, begin + (end - begin) / 2);
    build(begin + (end - begin) / 2, end);
  }
  node.skip = static_cast<Index>(nodes_.size());
  nodes_[n] = node;
  return n;
}

// Van Oosterom and Strackee, "The solid angle of a plane triangle", 1983.
double SurfaceWinding::solid_angle(Index face, const Vec3& x) const {
  const Vec3 a = surface_.corner(face, 0) - x, b = surface_.corner(face, 1) - x,
             c = surface_.corner(face, 2) - x;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double SurfaceWinding::operator()(const Vec3& x) const {
  double sum = 0;
  for (Index n = 0; n < static_cast<Index>(nodes_.size());) {  // ends: `skip` is ahead
    const Node& node = nodes_[n];
    const Vec3 r = node.centre - x;
    const double r2 = r.squaredNorm();
    if (r2 > kFar2 * node.radius2) {
      sum += node.dipole.dot(r) / (r2 * std::sqrt(r2));
      n = node.skip;
      continue;
    }
    if (node.skip == n + 1)
      for (Index i = node.begin; i < node.end; ++i) sum += solid_angle(i, x);
    ++n;
  }
  return sum / (4 * M_PI);
}

}  // namespace filmsticking
