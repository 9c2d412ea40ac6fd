// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// The film's area vector at each site (a third of those of its faces), zero for sites off the film. The two
/// layers of a dangling plate have opposite vectors and cancel at the sites that both hang on, so plates
/// leave no trace, neither in the sum nor in its direction.
std::vector<Vec3> film_dipoles(const Surface& film, std::size_t sites);

/// The winding number of dipoles (paper, section 5, W; Barill et al. 2018): sum of
/// a.(p-x) / (4 pi |p-x|^3), far groups taken as one. About 1 inside, 0 outside.
class WindingNumber {
 public:
  /// `sites` along a space-filling curve (SiteSet's order).
  WindingNumber(const std::vector<Vec3>& sites, const std::vector<Vec3>& dipoles);
  double operator()(const Vec3& x) const;

 private:
  struct Node {
    Vec3 centre, dipole;
    double radius2;
    Index begin, end, skip;  // skip: the next node that is not below this one
  };
  Index build(Index begin, Index end);
  std::vector<Vec3> position_, dipole_;
  std::vector<Node> nodes_;
};

}  // namespace filmsticking
