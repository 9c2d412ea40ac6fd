// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/face_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/parallel.h"

namespace filmsticking {

FaceTree::FaceTree(const Surface& surface) : faces_(surface.triangles.size()) {
  const std::size_t blocks = (faces_ + kBlock - 1) / kBlock;
  while (first_ < blocks) first_ *= 2;
  box_.resize(first_ + blocks);
  parallel_each(blocks, [&](std::size_t i) {
    const std::size_t end = std::min((i + 1) * kBlock, faces_);
    Eigen::AlignedBox3d box;
    for (std::size_t t = i * kBlock; t < end; ++t)
      for (int k = 0; k < 3; ++k) box.extend(surface.corner(static_cast<Index>(t), k));
    box_[first_ + i] = rounded(box);
  });
  for (std::size_t level = first_ / 2; level > 0; level /= 2)
    parallel_each(level, [&](std::size_t k) {
      for (const std::size_t child : {2 * (level + k), 2 * (level + k) + 1})
        if (child < box_.size()) box_[level + k].extend(box_[child]);
    });
}

FaceTree::Box FaceTree::rounded(const Eigen::AlignedBox3d& exact) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Box box(exact.min().cast<float>(), exact.max().cast<float>());
  for (int k = 0; k < 3; ++k) {
    box.min()[k] = std::nextafter(box.min()[k], -kInfinity);
    box.max()[k] = std::nextafter(box.max()[k], kInfinity);
  }
  return box;
}

void FaceTree::add(Index face, const Box& box) {
  for (std::size_t i = first_ + static_cast<std::size_t>(face) / kBlock; i > 0 && !box_[i].contains(box);
       i /= 2)
    box_[i].extend(box);
}

}  // namespace filmsticking
