// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frame.h"

namespace filmsticking::stream {

/// Sensor poses over time, in rising order.
class Trajectory {
 public:
  /// Adds a pose; times must rise. Throws StreamError otherwise.
  void add(double time, const Pose& pose);

  std::size_t size() const { return times_.size(); }

  /// The pose at that time: one that was added, or interpolated between two that are at most `gap` apart.
  /// None otherwise.
  std::optional<Pose> at(double time, double gap = 0.2) const;

  /// The n-th pose.
  const Pose& operator[](std::size_t n) const { return poses_[n]; }

 private:
  std::vector<double> times_;
  std::vector<Pose> poses_;
};

/// Reads the format of the TUM RGB-D benchmark: one line "time tx ty tz qx qy qz qw" a pose, from sensor to
/// world, lengths in the clouds' unit. Lines that begin with # are skipped. Throws StreamError.
Trajectory parse_trajectory(std::string_view text);

/// A line of that format.
std::string trajectory_line(double time, const Pose& pose);

}  // namespace filmsticking::stream
