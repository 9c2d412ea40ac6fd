// SPDX-License-Identifier: GPL-3.0-or-later
#include "voxel_map.h"

#include <algorithm>
#include <cmath>

namespace filmsticking::capture {

VoxelMap::VoxelMap(double leaf, std::size_t most) : leaf_(leaf), most_(most) {}

std::size_t VoxelMap::KeyHash::operator()(const Key& key) const {
  std::uint64_t hash = 0;
  for (const std::int64_t k : key) {
    hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 32;
  }
  return hash;
}

VoxelMap::Cell& VoxelMap::cell_at(const Key& key) {
  const auto [found, is_new] = index_of_.emplace(key, cells_.size());
  if (is_new) {
    cells_.emplace_back();
    cells_.back().key = key;
  }
  return cells_[found->second];
}

void VoxelMap::add(const io::Model& frame) {
  ++frame_;
  coloured_ = coloured_ && !frame.colours.empty();
  for (std::size_t i = 0; i < frame.positions.size(); ++i) {
    const Point& p = frame.positions[i];
    Key key;
    bool numbered = true;
    for (int axis = 0; axis < 3; ++axis) {
      const double cell = std::floor(p[axis] / leaf_);
      numbered = numbered && std::abs(cell) < 1e15;
      key[axis] = numbered ? static_cast<std::int64_t>(cell) : 0;
    }
    if (!numbered) continue;
    Cell& cell = cell_at(key);
    for (int axis = 0; axis < 3; ++axis) {
      cell.sum[axis] += p[axis];
      if (coloured_) cell.colour[axis] += frame.colours[i][axis];
    }
    ++cell.points;
    if (cell.last_frame != frame_) ++cell.frames;
    cell.last_frame = frame_;
    while (cells_.size() > most_) coarsen();
  }
}

void VoxelMap::coarsen() {
  const std::vector<Cell> fine = std::move(cells_);
  cells_.clear();
  index_of_.clear();
  leaf_ *= 2;
  for (const Cell& cell : fine) {
    Key key = cell.key;
    for (std::int64_t& k : key) k = k >= 0 ? k / 2 : -((1 - k) / 2);
    Cell& to = cell_at(key);
    for (int axis = 0; axis < 3; ++axis) {
      to.sum[axis] += cell.sum[axis];
      to.colour[axis] += cell.colour[axis];
    }
    to.points += cell.points;
    to.frames = std::max(to.frames, cell.frames);
    to.last_frame = std::max(to.last_frame, cell.last_frame);
  }
}

io::Model VoxelMap::points(std::uint32_t frames) const {
  io::Model model;
  for (const Cell& cell : cells_) {
    if (cell.frames < frames) continue;
    const double n = cell.points;
    model.positions.push_back({cell.sum[0] / n, cell.sum[1] / n, cell.sum[2] / n});
    if (!coloured_) continue;
    io::Colour colour;
    for (int axis = 0; axis < 3; ++axis)
      colour[axis] = static_cast<std::uint8_t>(std::lround(cell.colour[axis] / n));
    model.colours.push_back(colour);
  }
  return model;
}

}  // namespace filmsticking::capture
