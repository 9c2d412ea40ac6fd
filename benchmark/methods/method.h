// SPDX-License-Identifier: GPL-3.0-or-later
// What run_method knows about a method of reconstruction.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "filmsticking/report.h"
#include "filmsticking/types.h"
#include "stopwatch.h"

namespace filmsticking::bench {

/// What a method made of a cloud. Wall times in seconds.
struct Outcome {
  Mesh mesh;
  double needs_seconds = 0;        ///< what had to be there first, such as normals
  double seconds = 0;              ///< the method alone, from the array of points to the array of triangles
  std::vector<RoomSeconds> rooms;  ///< parts of `seconds`, where the method tells them
};

/// A method. `run` may throw, crash or never end: it has a process of its own.
struct Method {
  const char* name;
  const char* description;
  bool makes_mesh;                                                ///< false: only its time counts
  Outcome (*run)(const std::vector<Point>& points, int threads);  ///< threads 0: all
};

/// The methods that this program holds.
const std::vector<Method>& methods();

}  // namespace filmsticking::bench
