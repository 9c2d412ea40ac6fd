// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/face_tree.h"
#include "geometry/surface.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// Do new faces meet a surface, that grows by them?
class MeetingTree {
 public:
  /// `surface` must outlive the tree; faces may be appended to it.
  explicit MeetingTree(const Surface& surface);

  /// Those of these faces, by their places, that meet the surface, or one before them (unless
  /// `apart_from_each_other`), elsewhere than in common corners. Rounding counts as meeting. Throws
  /// Cancelled.
  std::vector<std::size_t> meeting(const std::vector<Corners>& faces, bool apart_from_each_other,
                                   const Cancel& cancel = {});

 private:
  bool meets_surface(const Corners& face) const;

  const Surface& surface_;
  std::size_t faces_;  // when the tree was made
  double piece_ = 0;   // longest side of a piece of a face, for which boxes are looked up
  FaceTree tree_;
};

}  // namespace filmsticking
