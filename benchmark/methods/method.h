// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of a method of reconstruction in run_method.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "filmsticking/report.h"
#include "filmsticking/types.h"
#include "stopwatch.h"

namespace filmsticking::bench {

/// The result of a method for a cloud. Wall times in seconds.
struct Outcome {
  Mesh mesh;
  double needs_seconds = 0;        ///< the time of what the method needs first, such as normals
  double seconds = 0;              ///< the method alone, from the array of points to the array of triangles
  std::vector<RoomSeconds> rooms;  ///< parts of `seconds`, where the method reports them
  std::string warning;             ///< of a doubtful result; empty: none
  int steps = 0, fields = 0;       ///< of a film: its steps, and how often a field corrected it
};

/// A cloud whose sensors are known: one of the two at least.
struct SeenCloud {
  std::vector<Point> points;
  std::vector<Point> sensors;      ///< where each point was seen from; empty: not known
  std::optional<Point> direction;  ///< in which a far sensor looked
};

/// A method. `run` may throw, crash or never end: it has a process of its own.
struct Method {
  const char* name;
  const char* description;
  bool makes_mesh;                                                ///< false: only its time counts
  Outcome (*run)(const std::vector<Point>& points, int threads);  ///< threads 0: all
  /// Instead of `run`, of methods that need to know the sensors.
  Outcome (*run_seen)(const SeenCloud& cloud, int threads) = nullptr;
};

/// The methods of this program.
const std::vector<Method>& methods();

}  // namespace filmsticking::bench
