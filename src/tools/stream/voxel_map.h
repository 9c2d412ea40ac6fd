// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "io/model.h"

namespace filmsticking::capture {

/// Fuses points of any number of frames: one point, the mean, for each cell of a grid. Memory is bounded:
/// with too many cells, the grid gets coarser by a factor of two.
class VoxelMap {
 public:
  /// `leaf`: width of a cell, above zero. `most`: cells allowed, at least one.
  VoxelMap(double leaf, std::size_t most);

  /// Adds a frame's points, in world coordinates. Points that are not finite, or too far out for a number of
  /// their cell, are left out.
  void add(const io::Model& frame);

  std::size_t size() const { return cells_.size(); }
  double leaf() const { return leaf_; }

  /// The means of the cells that at least `frames` frames have hit, in the order in which the cells were
  /// first hit. With colours if every point had one.
  io::Model points(std::uint32_t frames = 1) const;

 private:
  using Key = std::array<std::int64_t, 3>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  struct Cell {
    Key key{};
    Point sum{};
    std::array<double, 3> colour{};
    std::uint32_t points = 0;
    std::uint32_t frames = 0;
    std::uint32_t last_frame = 0;
  };

  Cell& cell_at(const Key& key);
  void coarsen();

  double leaf_;
  std::size_t most_;
  std::uint32_t frame_ = 0;  ///< number of the one that is being added, from one
  bool coloured_ = true;
  std::vector<Cell> cells_;
  std::unordered_map<Key, std::size_t, KeyHash> index_of_;
};

}  // namespace filmsticking::capture
