// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_accumulator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace filmsticking::stream {

void Accumulator::set_bounds(const Bounds& bounds) {
  bounds_ = bounds;
  refill(std::exchange(held_, {}));
  forget();
}

void Accumulator::add(const io::Model& frame) {
  ++frame_;
  viewpoint_ = frame.viewpoint;
  const bool coloured = !frame.colours.empty();
  for (std::size_t k = 0; k < frame.positions.size(); ++k) {
    Held point{{}, coloured ? frame.colours[k] : io::Colour{}, coloured, frame_};
    bool representable = true;
    for (int axis = 0; axis < 3; ++axis) {
      const double x = frame.positions[k][axis];
      representable =
          representable && std::abs(x) <= double{std::numeric_limits<float>::max()};  // no NaN either
      if (representable) point.position[axis] = static_cast<float>(x);
    }
    if (representable) put(point);
  }
  forget();
}

void Accumulator::clear() {
  held_.clear();
  cells_.clear();
  viewpoint_.reset();
}

io::Model Accumulator::cloud() const {
  io::Model model;
  model.viewpoint = viewpoint_;
  model.positions.reserve(held_.size());
  const bool coloured =
      std::all_of(held_.begin(), held_.end(), [](const Held& point) { return point.coloured; });
  for (const Held& point : held_) {
    model.positions.push_back({point.position[0], point.position[1], point.position[2]});
    if (coloured) model.colours.push_back(point.colour);
  }
  return model;
}

std::size_t Accumulator::CellHash::operator()(const Cell& cell) const {
  std::size_t hash = 0;
  for (const double x : cell) hash = hash * 0x9e3779b97f4a7c15u + std::hash<double>()(x);
  return hash;
}

Accumulator::Cell Accumulator::cell_of(const Held& point) const {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis) cell[axis] = std::floor(point.position[axis] / bounds_.voxel);
  return cell;
}

void Accumulator::put(const Held& point) {
  if (bounds_.voxel > 0) {
    const auto [cell, fresh] = cells_.try_emplace(cell_of(point), held_.size());
    if (!fresh) {
      Held& former = held_[cell->second];
      if (former.frame < point.frame) former = point;
      return;
    }
  }
  held_.push_back(point);
}

void Accumulator::refill(const std::vector<Held>& points) {
  held_.clear();
  cells_.clear();
  for (const Held& point : points) put(point);
}

void Accumulator::forget() {
  std::int64_t oldest = bounds_.window > 0 ? frame_ - bounds_.window + 1 : 0;
  std::map<std::int64_t, std::size_t> sizes;  // of the frames, what is held of them
  for (const Held& point : held_)
    if (point.frame >= oldest) ++sizes[point.frame];
  if (sizes.empty()) return clear();

  // Whole frames go, but never the newest: that one is thinned evenly where it is too large by itself.
  std::size_t kept = 0;
  std::int64_t given_up = 0;
  for (auto frame = sizes.rbegin(); frame != sizes.rend(); ++frame) {
    if (given_up > 0 || (kept > 0 && kept + frame->second > bounds_.max_points)) {
      given_up += static_cast<std::int64_t>(frame->second);
      continue;
    }
    kept += frame->second;
    oldest = frame->first;
  }
  const std::size_t most = std::min(kept, bounds_.max_points);
  given_up += static_cast<std::int64_t>(kept - most);
  given_up_ += given_up;
  if (kept == held_.size() && most == kept) return;

  std::vector<Held> points;
  points.reserve(most);
  std::size_t seen = 0;
  for (const Held& point : held_) {
    if (point.frame < oldest) continue;
    ++seen;
    if (seen * most / kept > (seen - 1) * most / kept) points.push_back(point);
  }
  refill(points);
}

}  // namespace filmsticking::stream
