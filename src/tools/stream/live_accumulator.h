// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "io/model.h"

namespace filmsticking::stream {

/// What is held of the frames that came.
struct Bounds {
  double voxel = 0;  ///< one measured point for each cell of a grid of this width; 0: all points
  int window = 1;    ///< the newest frames to hold; 0: all
  std::size_t max_points = 200000;  ///< at most this many points; the oldest frames are given up first
};

/// Collects the points of frames within bounds, whatever comes and for however long.
///
/// Points stay measured ones, since a mesh through them shall be one through what was seen: a cell keeps the
/// first point of the newest frame that met it, not a mean. So what a moving window forgets is what was not
/// seen again.
class Accumulator {
 public:
  /// Holds what is there already to the new bounds, too.
  void set_bounds(const Bounds& bounds);

  /// Adds one frame's points, rounded to single precision, as messages have them.
  void add(const io::Model& frame);

  void clear();

  /// All points, and the newest frame's viewpoint; with colours if all have one.
  io::Model cloud() const;

  std::size_t size() const { return held_.size(); }

  /// Points given up for the sake of Bounds::max_points so far.
  std::int64_t given_up() const { return given_up_; }

 private:
  struct Held {
    std::array<float, 3> position;
    io::Colour colour;
    bool coloured;
    std::int64_t frame;
  };
  using Cell = std::array<double, 3>;  // whole numbers, of any size
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };

  Cell cell_of(const Held& point) const;
  void put(const Held& point);
  void forget();
  void refill(const std::vector<Held>& points);

  Bounds bounds_;
  std::vector<Held> held_;
  std::unordered_map<Cell, std::size_t, CellHash> cells_;  // where in held_ the cell's point is
  std::int64_t frame_ = 0;                                 // the newest
  std::int64_t given_up_ = 0;
  std::optional<Point> viewpoint_;
};

}  // namespace filmsticking::stream
