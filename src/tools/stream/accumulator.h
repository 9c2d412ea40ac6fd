// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/filter_options.h"
#include "frame.h"
#include "io/model.h"
#include "pose_source.h"
#include "voxel_map.h"

namespace filmsticking::capture {

struct AccumulatorOptions {
  filters::FilterOptions filters;  ///< for each frame
  double leaf = 0;  ///< width of a fused cell; 0: half as much again as the first frame's spacing
  std::size_t most_points = 1000000;  ///< the cells get coarser beyond
};

/// Makes one cloud of many frames: each is filtered, placed and fused.
class Accumulator {
 public:
  Accumulator(AccumulatorOptions options, std::unique_ptr<PoseSource> poses);

  /// Adds a frame, or leaves it out and says why in a clause without its name. Never throws CaptureError.
  std::optional<std::string> add(const Frame& frame);

  /// A frame that was fused.
  struct Placed {
    std::string name;
    std::optional<double> time;
    Pose pose;
  };
  const std::vector<Placed>& placed() const { return placed_; }

  std::size_t left_out() const { return left_out_; }

  /// Fused points so far.
  std::size_t size() const { return map_ ? map_->size() : 0; }

  /// Width of a fused cell; 0 before the first frame.
  double leaf() const { return map_ ? map_->leaf() : 0; }

  /// The fused points that at least so many frames have seen.
  io::Model points(int seen_by = 1) const;

 private:
  AccumulatorOptions options_;
  std::unique_ptr<PoseSource> poses_;
  std::optional<VoxelMap> map_;
  std::vector<Placed> placed_;
  std::size_t left_out_ = 0;
};

}  // namespace filmsticking::capture
