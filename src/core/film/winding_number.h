// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Per site the film's normal there, as long as one sample covers area; zero for sites off the film. Normals
/// are weighted towards short faces (surface_normals()): by area, the wide faces of a dangling plate would
/// own its rim. `spacing`: per site.
std::vector<Vec3> film_dipoles(const Surface& film, const std::vector<double>& spacing);

/// The winding number of dipoles a at places p (paper, section 5, W): the sum of a.(p-x) / (4 pi |p-x|^3),
/// about 1 inside and 0 outside. Far groups count as one dipole (Barill et al. 2018). By hand: libigl's is
/// not in Debian 12.
class WindingNumber {
 public:
  /// `sites` must follow a space-filling curve, as in SiteSet. `dipoles`: per site.
  WindingNumber(const std::vector<Vec3>& sites, const std::vector<Vec3>& dipoles);
  double operator()(const Vec3& x) const;

 private:
  struct Node {
    Vec3 centre, dipole;
    double radius2;
    Index begin, end, skip;  // skip: the next node outside this subtree
  };
  Index build(Index begin, Index end);
  std::vector<Vec3> position_, dipole_;
  std::vector<Node> nodes_;
};

/// The winding number of a triangle surface: the sum of its faces' solid angles over 4 pi. Exact near a face
/// but for rounding; far groups count as one dipole.
class SurfaceWinding {
 public:
  /// Near faces should have near numbers. The surface is copied.
  explicit SurfaceWinding(Surface surface);
  double operator()(const Vec3& x) const;

 private:
  struct Node {
    Vec3 centre = Vec3::Zero(), dipole = Vec3::Zero();
    double radius2 = 0;
    Index begin = 0, end = 0, skip = 0;  // skip: the next node outside this subtree
  };
  Index build(Index begin, Index end);
  double solid_angle(Index face, const Vec3& x) const;
  Surface surface_;
  std::vector<Node> nodes_;
};

}  // namespace filmsticking
