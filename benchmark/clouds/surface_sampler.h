// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filmsticking/types.h"
#include "random.h"
#include "sample.h"

namespace filmsticking::bench {

/// Draws points of a surface, every part of it with a chance in proportion to its area. This is the Monte
/// Carlo sampling; the other samplings choose among its draws.
class SurfaceSampler {
 public:
  /// `mesh` must outlive the sampler. Throws std::invalid_argument if it has no area.
  explicit SurfaceSampler(const Mesh& mesh);

  /// Takes patches away that are never drawn from: the surface within some balls around points of it, a
  /// `share` of the area in all, in [0, 1).
  void take_patches_away(double share, Random& random);

  Sample draw(Random& random) const;

  double area() const { return area_ * (1 - missing_); }  ///< of the part that is drawn from
  const Vec3& low() const { return low_; }                ///< the box of the mesh
  const Vec3& high() const { return high_; }
  double diagonal() const { return (high_ - low_).norm(); }

  struct Ball {
    Vec3 centre;
    double radius;
  };
  const std::vector<Ball>& holes() const { return holes_; }

 private:
  Vec3 corner(const Triangle& triangle, int k) const;
  Sample draw_from_whole(Random& random) const;
  bool is_missing(const Vec3& p) const;

  const Mesh& mesh_;
  std::vector<double> area_up_to_;  // of the faces up to each one, itself included
  double area_ = 0;
  double missing_ = 0;  // share of the area within the holes
  std::vector<Ball> holes_;
  Vec3 low_, high_;
};

}  // namespace filmsticking::bench
