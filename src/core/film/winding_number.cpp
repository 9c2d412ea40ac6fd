// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/winding_number.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/surface_normals.h"

namespace filmsticking {
namespace {

// Sources of a group that is not divided.
constexpr Index kFewSites = 8, kFewFaces = 4;

}  // namespace

std::vector<Vec3> film_dipoles(const Surface& film, const std::vector<double>& spacing) {
  std::vector<Vec3> dipole = surface_normals(film, std::vector<Vec3>(spacing.size(), Vec3::Zero()));
  for (std::size_t s = 0; s < spacing.size(); ++s) dipole[s] *= spacing[s] * spacing[s];
  return dipole;
}

WindingNumber::WindingNumber(const std::vector<Vec3>& sites, const std::vector<Vec3>& dipoles) {
  for (std::size_t i = 0; i < sites.size(); ++i)
    if (dipoles[i].squaredNorm() > 0) position_.push_back(sites[i]), dipole_.push_back(dipoles[i]);
  if (position_.empty()) return;
  tree_.build(0, static_cast<Index>(position_.size()), kFewSites, [&](Index begin, Index end) {
    DipoleTree::Group group;
    double mass = 0;
    for (Index i = begin; i < end; ++i) {
      const double a = dipole_[i].norm();
      mass += a, group.centre += a * position_[i], group.dipole += dipole_[i];
    }
    group.centre /= mass;
    for (Index i = begin; i < end; ++i)
      group.radius2 = std::max(group.radius2, (position_[i] - group.centre).squaredNorm());
    return group;
  });
}

double WindingNumber::operator()(const Vec3& x) const {
  return tree_(x, [&](Index i) {
    const Vec3 q = position_[i] - x;
    // A dipole stands for a disc: within the radius its field is bounded.
    const double q2 = q.squaredNorm() + dipole_[i].norm() / M_PI;
    return dipole_[i].dot(q) / (q2 * std::sqrt(q2));
  });
}

SurfaceWinding::SurfaceWinding(Surface surface) : surface_(std::move(surface)) {
  if (surface_.triangles.empty()) return;
  tree_.build(0, static_cast<Index>(surface_.triangles.size()), kFewFaces, [&](Index begin, Index end) {
    DipoleTree::Group group;
    Eigen::AlignedBox3d box;
    for (Index i = begin; i < end; ++i) {
      group.dipole += surface_.area_vector2(i) / 2;
      for (int k = 0; k < 3; ++k) box.extend(surface_.corner(i, k));
    }
    group.centre = box.center();
    group.radius2 = box.diagonal().squaredNorm() / 4;
    return group;
  });
}

// Van Oosterom and Strackee, "The solid angle of a plane triangle", 1983.
double SurfaceWinding::solid_angle(Index face, const Vec3& x) const {
  const Vec3 a = surface_.corner(face, 0) - x, b = surface_.corner(face, 1) - x,
             c = surface_.corner(face, 2) - x;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double SurfaceWinding::operator()(const Vec3& x) const {
  return tree_(x, [&](Index face) { return solid_angle(face, x); });
}

}  // namespace filmsticking
