// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filters/filter_options.h"
#include "frame.h"
#include "mean_cloud.h"
#include "pose_source.h"

namespace filmsticking::stream {

struct AccumulatorOptions {
  filters::FilterOptions filters;     ///< run on each frame
  double width = 0;                   ///< of a fused cell; 0: 1.5 times the first frame's mean spacing
  std::size_t most_points = 1000000;  ///< with more cells than this, their width doubles
};

/// Makes one cloud from a recording: filters, places and averages its frames.
class Accumulator {
 public:
  Accumulator(AccumulatorOptions options, PoseSource poses);

  /// Adds a frame; else returns why it is left out, as a clause without the frame's name. Never throws
  /// StreamError.
  std::optional<std::string> add(const Frame& frame);

  /// A frame that was added.
  struct Placed {
    std::string name;
    std::optional<double> time;
    Pose pose;
  };
  const std::vector<Placed>& placed() const { return placed_; }

  std::size_t left_out() const { return left_out_; }

  /// The number of fused points.
  std::size_t size() const { return fused_ ? fused_->size() : 0; }

  /// Width of a fused cell; 0 before the first frame.
  double width() const { return fused_ ? fused_->width() : 0; }

  /// The fused points that at least `seen_by` frames have hit: positions, colours if
  /// all frames have them, and where each was seen from as MeanCloud::cloud() says it.
  pcl::PCLPointCloud2 cloud(int seen_by = 1) const;

 private:
  AccumulatorOptions options_;
  PoseSource poses_;
  std::optional<MeanCloud> fused_;
  std::vector<Placed> placed_;
  std::size_t left_out_ = 0;
};

}  // namespace filmsticking::stream
