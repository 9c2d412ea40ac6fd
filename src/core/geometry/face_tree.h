// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/surface.h"

namespace filmsticking {

/// Bounding boxes of faces: an implicit binary tree over blocks of eight faces in the order of their numbers,
/// so near faces should have near numbers. Boxes grow where a face moves and never shrink.
class FaceTree {
 public:
  using Box = Eigen::AlignedBox3f;

  explicit FaceTree(const Surface& surface);

  static Box rounded(const Eigen::AlignedBox3d& exact);  ///< outward to floats

  /// Grows the boxes around the face to contain this box too. Not from two threads at once.
  void add(Index face, const Box& box);

  /// Calls visit(face), in rising order, for the faces of all blocks whose boxes meet this box, until it
  /// returns false. Returns whether it never did.
  template <class Visit>
  bool all(const Box& box, const Visit& visit) const;

 private:
  static constexpr std::size_t kBlock = 8;

  std::size_t faces_ = 0,
              first_ = 1;  // the node of the first block; the children of node i are 2i and 2i + 1
  std::vector<Box> box_;
};

template <class Visit>
bool FaceTree::all(const Box& box, const Visit& visit) const {
  std::array<std::size_t, 64> stack;  // one entry per level, and one
  std::size_t top = 0;
  stack[top++] = 1;
  while (top > 0) {
    const std::size_t i = stack[--top];
    if (i >= box_.size() || !box_[i].intersects(box)) continue;
    if (i < first_) {
      stack[top++] = 2 * i + 1, stack[top++] = 2 * i;
      continue;
    }
    const std::size_t begin = (i - first_) * kBlock, end = std::min(begin + kBlock, faces_);
    for (std::size_t t = begin; t < end; ++t)
      if (!visit(static_cast<Index>(t))) return false;
  }
  return true;
}

}  // namespace filmsticking
