// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "filmsticking/types.h"
#include "geometry/vec.h"

namespace filmsticking {

/// A rotation that maps axes to axes: coordinates change their place and sign only.
struct AxisTurn {
  std::array<int, 3> axis{0, 1, 2};
  std::array<double, 3> sign{1, 1, 1};

  Vec3 operator()(const Vec3& p) const {
    return {sign[0] * p[axis[0]], sign[1] * p[axis[1]], sign[2] * p[axis[2]]};
  }
  Vec3 back(const Vec3& p) const {
    Vec3 q;
    for (int k = 0; k < 3; ++k) q[axis[k]] = sign[k] * p[k];
    return q;
  }
};

/// The distinct finite points, scaled to a box of longest side 1 around the origin, in the order of a
/// space-filling curve.
struct SiteSet {
  /// Recentred, scaled, turned and moved by at most kPerturbation, so that no four lie on a circle.
  std::vector<Vec3> perturbed;
  std::vector<std::int32_t> input;  ///< site i is point input[i], the first of equal points
  std::int64_t non_finite = 0;
  std::int64_t duplicates = 0;
  /// Distinct points 10,000 times as far from the median point as two thirds of all: they would decide the
  /// scale.
  std::int64_t absurd = 0;
  Vec3 centre = Vec3::Zero();  ///< centre of the input's box, in the caller's unit
  double side = 1;             ///< longest side of the input's box, in the caller's unit; > 0

  AxisTurn turn;  ///< chosen so that a cloud turned by 90 degrees gives the same sites

  std::size_t size() const { return perturbed.size(); }
  /// Whether all sites lie on one plane, line or point, up to rounding to float. `points`: the points that
  /// the set was made from.
  bool coplanar(const PointsView& points) const;
  /// The site's place before perturbation.
  Vec3 exact(const PointsView& points, std::size_t site) const {
    return to_unit(points[static_cast<std::size_t>(input[site])]);
  }

  Vec3 to_unit(const Point& p) const { return turn((Vec3(p[0], p[1], p[2]) - centre) / side); }
  Point to_input(const Vec3& p) const {
    const Vec3 q = turn.back(p) * side + centre;
    return {q.x(), q.y(), q.z()};
  }
};

/// The most that a site is moved along each axis, in units of the box. Grids, voxel filters and CAD vertices
/// make cospherical sites the rule. A float resolves 6e-8 of the box, so this changes no measured digit.
constexpr double kPerturbation = 2e-8;

/// `keep_absurd`: takes them as sites. Never fails; may give fewer sites than points, or none. The order and
/// the perturbation depend on the coordinates alone. So the result does not depend on the order of the
/// points, a rotation by 90 degrees (unless it maps the cloud to itself), a scale by a power of two, or a
/// shift that rounds nothing.
SiteSet make_site_set(const PointsView& points, bool keep_absurd = false);

}  // namespace filmsticking
