// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Nearest of some points. Indices are those of the array that was given.
class PointTree {
 public:
  explicit PointTree(const std::vector<Vec3>& points);  // must outlive the tree
  ~PointTree();
  /// The nearest point and, through `distance2`, its squared distance; kNone for an empty tree.
  Index nearest(const Vec3& x, double* distance2 = nullptr) const;
  /// The k nearest, nearest first.
  std::vector<Index> nearest(const Vec3& x, std::size_t k) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Nearest point of a surface, which must outlive the tree and not be empty.
class SurfaceTree {
 public:
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
