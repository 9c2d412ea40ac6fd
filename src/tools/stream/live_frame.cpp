// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_frame.h"

#include <cstddef>

namespace filmsticking::stream {

void keep_range(io::Model& frame, double least, double most) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < frame.positions.size(); ++k) {
    const Point& p = frame.positions[k];
    const double range = Eigen::Vector3d(p[0], p[1], p[2]).norm();
    if (range < least || (most > 0 && range > most)) continue;
    frame.positions[kept] = p;
    if (!frame.colours.empty()) frame.colours[kept] = frame.colours[k];
    ++kept;
  }
  frame.positions.resize(kept);
  if (!frame.colours.empty()) frame.colours.resize(kept);
}

void move(io::Model& frame, const Pose& pose) {
  const auto move = [&](Point& p) {
    const Eigen::Vector3d moved = pose * Eigen::Vector3d(p[0], p[1], p[2]);
    p = {moved[0], moved[1], moved[2]};
  };
  for (Point& p : frame.positions) move(p);
  if (frame.viewpoint) move(*frame.viewpoint);
}

}  // namespace filmsticking::stream
