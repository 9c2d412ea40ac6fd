// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Nearest points, exactly. Ties go to the lower index. Results are indices into the array given.
///
/// By hand: FLANN's exact index (1.9.2, double distances, a result set that keeps our ties) finds the same
/// neighbours in the same time. 12 neighbours each of 1M points take 1.5 s of one thread with either. But
/// when memory ends FLANN's node pool follows a null pointer; this tree throws bad_alloc.
class PointTree {
 public:
  /// `points` must outlive the tree.
  explicit PointTree(const std::vector<Vec3>& points);
  ~PointTree();
  /// The nearest point; kNone without points. `distance2`: receives its squared distance, if not null.
  Index nearest(const Vec3& x, double* distance2 = nullptr) const;
  /// The k nearest points, nearest first; all if there are fewer.
  std::vector<Index> nearest(const Vec3& x, std::size_t k) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Nearest points on a surface.
class SurfaceTree {
 public:
  /// `surface` must have a face; it is copied.
  explicit SurfaceTree(const Surface& surface);
  ~SurfaceTree();
  struct Hit {
    Vec3 point;
    Index triangle;
  };
  Hit nearest(const Vec3& x) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace filmsticking
