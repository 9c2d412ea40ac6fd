// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Per site the film's normal there, as long as one sample covers area; zero for sites off the film. Normals
/// are weighted towards short faces (surface_normals()): by area, the wide faces of a dangling plate would
/// own its rim. `spacing`: per site.
std::vector<Vec3> film_dipoles(const Surface& film, const std::vector<double>& spacing);

/// A tree over sources of a winding field. A far group counts as one dipole (Barill et al. 2018).
class DipoleTree {
 public:
  /// A group of sources: its sum, its centre and the squared distance of the farthest part from that.
  struct Group {
    Vec3 centre = Vec3::Zero(), dipole = Vec3::Zero();
    double radius2 = 0;
  };

  /// Halves [begin, end) down to groups of at most `few`; describe(begin, end) returns the Group of a range.
  template <class Describe>
  void build(Index begin, Index end, Index few, const Describe& describe) {
    const std::size_t n = nodes_.size();
    nodes_.push_back({describe(begin, end), begin, end, 0});
    if (end - begin > few) {
      build(begin, begin + (end - begin) / 2, few, describe);
      build(begin + (end - begin) / 2, end, few, describe);
    }
    nodes_[n].skip = static_cast<Index>(nodes_.size());
  }

  /// The field at x over 4 pi. near(i): the field of source i, where its group is near.
  template <class Near>
  double operator()(const Vec3& x, const Near& near) const {
    double sum = 0;
    for (std::size_t n = 0; n < nodes_.size();) {  // ends: `skip` is ahead
      const Node& node = nodes_[n];
      const Vec3 r = node.group.centre - x;
      const double r2 = r.squaredNorm();
      if (r2 > kFar2 * node.group.radius2 && node.end - node.begin > 1) {
        sum += node.group.dipole.dot(r) / (r2 * std::sqrt(r2));
        n = static_cast<std::size_t>(node.skip);
        continue;
      }
      if (node.skip == static_cast<Index>(n) + 1)
        for (Index i = node.begin; i < node.end; ++i) sum += near(i);
      ++n;
    }
    return sum / (4 * M_PI);
  }

 private:
  static constexpr double kFar2 = 2.3 * 2.3;  // squared radii from which a group is far (Barill et al.)
  struct Node {
    Group group;
    Index begin, end, skip;  // skip: the next node outside this subtree
  };
  std::vector<Node> nodes_;
};

/// The winding number of dipoles a at places p (paper, section 5, W): the sum of a.(p-x) / (4 pi |p-x|^3),
/// about 1 inside and 0 outside. By hand: libigl's is not in Debian 12.
class WindingNumber {
 public:
  /// `sites` must follow a space-filling curve, as in SiteSet. `dipoles`: per site.
  WindingNumber(const std::vector<Vec3>& sites, const std::vector<Vec3>& dipoles);
  double operator()(const Vec3& x) const;

 private:
  std::vector<Vec3> position_, dipole_;
  DipoleTree tree_;
};

/// The winding number of a triangle surface: the sum of its faces' solid angles over 4 pi. Exact near a face
/// but for rounding.
class SurfaceWinding {
 public:
  /// Near faces should have near numbers. The surface is copied.
  explicit SurfaceWinding(Surface surface);
  double operator()(const Vec3& x) const;

 private:
  double solid_angle(Index face, const Vec3& x) const;
  Surface surface_;
  DipoleTree tree_;
};

}  // namespace filmsticking
