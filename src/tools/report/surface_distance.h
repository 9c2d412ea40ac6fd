// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "surface.h"

namespace filmsticking::mesh_report {

/// The nearest point of a surface, seen from another point.
struct Nearest {
  double distance = 0;
  std::size_t triangle = 0;
};

/// The nearest point of a surface, which must outlive this and have faces.
class SurfaceDistance {
 public:
  explicit SurfaceDistance(const Surface& surface);
  ~SurfaceDistance();
  SurfaceDistance(const SurfaceDistance&) = delete;
  SurfaceDistance& operator=(const SurfaceDistance&) = delete;

  /// For each of the points, by all threads; the same for any number of them.
  std::vector<Nearest> from(const std::vector<Vec3>& points) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace filmsticking::mesh_report
