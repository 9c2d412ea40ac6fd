// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Per site a third of the sum of its faces' area vectors; zero for sites off the film. `sites`: their
/// number. The two layers of a dangling plate have opposite area vectors, which cancel at the sites that both
/// share.
std::vector<Vec3> film_dipoles(const Surface& film, std::size_t sites);

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

}  // namespace filmsticking
