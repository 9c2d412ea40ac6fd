// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "filmsticking/types.h"
#include "geometry/vec.h"

namespace filmsticking {

/// A turn of the axes onto each other: no number changes but its sign.
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

/// The distinct finite points, in a box of longest side 1 around the origin and along a space-filling curve.
struct SiteSet {
  /// Recentred, scaled and turned, and moved by at most kPerturbation: no four on a circle.
  std::vector<Vec3> perturbed;
  std::vector<std::int32_t> input;  ///< site i is input point input[i]: of equal points the first
  std::int64_t non_finite = 0;
  std::int64_t duplicates = 0;
  Vec3 centre = Vec3::Zero();  ///< of the input's box, in the caller's unit
  double side = 1;             ///< longest side of the input's box, in the caller's unit; > 0

  AxisTurn turn;  ///< of the input's axes, by the coordinates alone: a cloud turned by 90 degrees is the same

  std::size_t size() const { return perturbed.size(); }
  /// Do all sites lie on one plane, line or point, but for rounding to float? `points`: what they were made
  /// of.
  bool coplanar(const PointsView& points) const;
  /// Where a site is that is not perturbed, of the points that it was made of.
  Vec3 exact(const PointsView& points, std::size_t site) const {
    return to_unit(points[static_cast<std::size_t>(input[site])]);
  }

  Vec3 to_unit(const Point& p) const { return turn((Vec3(p[0], p[1], p[2]) - centre) / side); }
  Point to_input(const Vec3& p) const {
    const Vec3 q = turn.back(p) * side + centre;
    return {q.x(), q.y(), q.z()};
  }
};

/// Half the width of the cube that a perturbed site stays in, in units of the box. Grids, voxel filters and
/// CAD vertices make cospherical sites the rule; a float has 6e-8 of the box left to say, so this changes
/// nothing that was measured.
constexpr double kPerturbation = 2e-8;

/// Never fails; fewer sites than points, perhaps none. The order and the perturbation depend on the
/// coordinates alone, so that the order of the input does not matter; nor do a turn by 90 degrees (unless it
/// takes the cloud to itself), a scale by a power of two, and a move that rounds nothing.
SiteSet make_site_set(const PointsView& points);

}  // namespace filmsticking
