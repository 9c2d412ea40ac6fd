// SPDX-License-Identifier: GPL-3.0-or-later
#include "method.h"
#include "peers.h"

namespace filmsticking::bench {

const std::vector<Method>& methods() {
  static const std::vector<Method> all = {
      {"open3d-ball-pivoting", "Open3D ball pivoting with oriented normals: radii 1, 2 and 4 spacings", true,
       run_open3d_ball_pivoting},
      {"open3d-poisson", "Open3D Poisson with oriented normals", true, run_open3d_poisson},
  };
  return all;
}

}  // namespace filmsticking::bench
