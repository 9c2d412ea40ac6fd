// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filmsticking/options.h"
#include "filters/filter_options.h"

namespace filmsticking::app {

/// Where the frames' poses come from.
enum class Align {
  Auto,    ///< the clouds' sensor poses where they have one; else by registration
  Poses,   ///< a trajectory file
  Sensor,  ///< the clouds' sensor poses
  Icp,     ///< registration
  Gicp,    ///< registration
};

/// What the user asked capture_to_mesh for.
struct CommandLine {
  std::vector<std::string> inputs;    ///< files, or one folder
  std::optional<std::string> device;  ///< a live camera
  std::string output;
  std::string poses;       ///< trajectory file; empty: none
  std::string save_poses;  ///< empty: not saved
  std::string save_cloud;  ///< empty: not saved
  Align align = Align::Auto;
  double fuse = 0;  ///< width of a fused cell; 0: by the first frame
  double min_overlap = 0.35;
  int seen_by = 1;
  int most_points = 1000000;
  int every = 0;   ///< frames between meshes while capturing; 0: none
  int stride = 1;  ///< every so manyth frame is used
  int frames = 0;  ///< at most; 0: all
  filters::FilterOptions filters;
  Options options;
  bool help = false;
  bool version = false;
};

/// Throws UsageError.
CommandLine parse_command_line(int argc, const char* const* argv);

/// The text of --help.
std::string usage();

}  // namespace filmsticking::app
