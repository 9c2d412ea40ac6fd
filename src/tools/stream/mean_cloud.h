// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "cells.h"
#include "io/cloud.h"

namespace filmsticking::stream {

/// Fuses frames into the mean of all points in each cell of a grid, for a recording that is meshed at the
/// end: averaging reduces the noise of the sensor. A stream that is meshed as it goes uses NewestCloud.
///
/// Memory is bounded: when there are too many cells, their width doubles.
class MeanCloud {
 public:
  /// `width`: of a cell, above zero. `most`: cells allowed, at least one.
  MeanCloud(double width, std::size_t most);

  /// Adds a frame's points, in world coordinates; `colours`: empty, or one a point; `sensor`: where they were
  /// seen from. Leaves out points that are not finite, or 1e15 cells or more from the origin.
  void add(const std::vector<Point>& points, const std::vector<io::Colour>& colours = {},
           const std::optional<Point>& sensor = std::nullopt);

  std::size_t size() const { return cells_.size(); }
  double width() const { return width_; }

  /// The means of the cells that at least `frames` frames have hit, in the order of the first hits.
  std::vector<Point> positions(std::uint32_t frames = 1) const;

  /// The same as a cloud; with the mean colours if every frame had colours, and in the fields of
  /// io::kStationFields the sensor that saw the cell from nearest, if one is known; NaN for a cell of none.
  pcl::PCLPointCloud2 cloud(std::uint32_t frames = 1) const;

 private:
  struct Sum {
    Cell cell{};
    Point position{};
    std::array<double, 3> colour{};
    Point sensor{NAN, NAN, NAN};
    double from_sensor = INFINITY;  // to the nearest
    std::uint32_t points = 0;
    std::uint32_t frames = 0;
    std::uint32_t last_frame = 0;

    void see(const Point& from, double distance);  // the first of equals stays
  };

  Sum& sum_of(const Cell& cell);
  void coarsen();

  double width_;
  std::size_t most_;
  std::uint32_t frame_ = 0;  ///< the number of frames so far
  bool coloured_ = true, seen_ = false;
  std::vector<Sum> cells_;
  std::unordered_map<Cell, std::size_t, CellHash> index_of_;  // in cells_
};

}  // namespace filmsticking::stream
