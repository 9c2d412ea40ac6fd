// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

#include "filmsticking/types.h"
#include "frame.h"

namespace filmsticking::stream {

/// What a NewestCloud holds of the frames that came.
struct Bounds {
  double voxel = 0;  ///< one measured point for each cell of a grid of this width; 0: all points
  int window = 1;    ///< the newest frames to hold; 0: all
  std::size_t max_points = 200000;  ///< at most this many points; the oldest frames are given up first
};

/// Fuses frames into the newest measured point in each cell of a grid, within bounds, for a stream that is
/// meshed as it goes: every vertex of the mesh is a point that was measured. A recording that is meshed at
/// the end uses MeanCloud.
///
/// A cell keeps the first point of the newest frame that hit it. So a moving window forgets what was not seen
/// again.
class NewestCloud {
 public:
  /// Applies to the points that are held already, too.
  void set_bounds(const Bounds& bounds);

  /// Adds a frame's points with all fields; x, y, z are moved by its pose and rounded to single precision.
  /// Leaves out points that are not finite then. Throws io::IoError for a cloud that has no positions or
  /// contradicts itself.
  void add(const Frame& frame);

  void clear();

  /// All points, the oldest first, with x, y, z, the fields that all held frames have, and in those of
  /// io::kStationFields where each was seen from: the place of its frame's sensor, or what the frame's own
  /// fields vp_x, vp_y and vp_z say, which are moved as x, y and z are.
  pcl::PCLPointCloud2 cloud() const;

  std::size_t size() const;

  /// Points given up because of Bounds::max_points so far.
  std::int64_t given_up() const { return given_up_; }

 private:
  struct Held {
    std::int64_t number;
    pcl::PCLPointCloud2 points;  ///< one row without padding
  };

  void drop_overtaken(std::size_t first_changed);
  void forget();

  Bounds bounds_;
  std::deque<Held> frames_;  // by their numbers
  std::int64_t frame_ = 0;   // the newest frame's number
  std::int64_t given_up_ = 0;
};

}  // namespace filmsticking::stream
