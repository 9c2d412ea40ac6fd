// SPDX-License-Identifier: GPL-3.0-or-later
#include "trajectory.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/text_scanner.h"
#include "stream_error.h"

namespace filmsticking::stream {

void Trajectory::add(double time, const Pose& pose) {
  if (!times_.empty() && !(time > times_.back())) throw StreamError("its times do not rise");
  times_.push_back(time);
  poses_.push_back(pose);
}

std::optional<Pose> Trajectory::at(double time, double gap) const {
  const auto after = std::lower_bound(times_.begin(), times_.end(), time);
  if (after == times_.end()) return std::nullopt;
  const auto k = after - times_.begin();
  if (*after == time) return poses_[k];
  if (k == 0 || times_[k] - times_[k - 1] > gap) return std::nullopt;
  const double share = (time - times_[k - 1]) / (times_[k] - times_[k - 1]);
  const Pose &a = poses_[k - 1], &b = poses_[k];
  const Eigen::Quaterniond rotation =
      Eigen::Quaterniond(a.linear()).slerp(share, Eigen::Quaterniond(b.linear()));
  return Pose(Eigen::Translation3d((1 - share) * a.translation() + share * b.translation()) * rotation);
}

Trajectory parse_trajectory(std::string_view text) {
  Trajectory trajectory;
  io::TextScanner file(text);
  std::size_t number = 0;
  for (std::string_view content; file.line(content);) {
    ++number;
    io::TextScanner line(content);
    io::TextScanner ahead(content);
    const std::string_view first = ahead.word();
    if (first.empty() || first[0] == '#') continue;
    double v[8];
    for (double& x : v)
      if (!line.number(x) || !std::isfinite(x))
        throw StreamError("line " + std::to_string(number) + " is not 'time tx ty tz qx qy qz qw'");
    const Eigen::Quaterniond rotation(v[7], v[4], v[5], v[6]);
    if (!(std::abs(rotation.norm() - 1) < 0.01))
      throw StreamError("line " + std::to_string(number) + " has a quaternion that is not of length 1");
    trajectory.add(v[0], Pose(Eigen::Translation3d(v[1], v[2], v[3]) * rotation.normalized()));
  }
  if (trajectory.size() == 0) throw StreamError("there are no poses in it");
  return trajectory;
}

std::string trajectory_line(double time, const Pose& pose) {
  const Eigen::Vector3d t = pose.translation();
  const Eigen::Quaterniond q(pose.linear());
  char line[300];
  std::snprintf(line, sizeof line, "%.9f %.9g %.9g %.9g %.9f %.9f %.9f %.9f\n", time, t.x(), t.y(), t.z(),
                q.x(), q.y(), q.z(), q.w());
  return line;
}

}  // namespace filmsticking::stream
