// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "surface.h"

namespace filmsticking::mesh_report {

/// The distance to the nearest of a set of points, which is not empty.
class PointDistance {
 public:
  explicit PointDistance(const std::vector<Vec3>& points);
  ~PointDistance();
  PointDistance(const PointDistance&) = delete;
  PointDistance& operator=(const PointDistance&) = delete;

  /// For each of the places, by all threads; the same for any number of them.
  std::vector<double> from(const std::vector<Vec3>& places) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace filmsticking::mesh_report
