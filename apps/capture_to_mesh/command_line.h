// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filmsticking/options.h"
#include "filters/filter_options.h"

namespace filmsticking::app {

/// The source of the poses of frames.
enum class Align {
  Auto,    ///< the sensor pose of a cloud if it has one, else registration
  Poses,   ///< a trajectory file
  Sensor,  ///< the sensor poses of the clouds
  Icp,     ///< registration
  Gicp,    ///< registration
};

/// The command line of capture_to_mesh.
struct CommandLine {
  std::vector<std::string> inputs;    ///< files, or one folder
  std::optional<std::string> device;  ///< a live camera
  std::string output;
  std::string poses;       ///< trajectory file; empty: none
  std::string save_poses;  ///< empty: not saved
  std::string save_cloud;  ///< empty: not saved
  Align align = Align::Auto;
  double fuse = 0;  ///< width of a fused cell; 0: chosen by the first frame
  double min_overlap = 0.35;
  int seen_by = 1;
  int most_points = 1000000;
  int every = 0;   ///< frames between meshes while capturing; 0: none
  int stride = 1;  ///< use one frame of so many
  int frames = 0;  ///< at most; 0: all
  filters::FilterOptions filters;
  Options options;
  bool doubles = false;  ///< write double coordinates even where single precision suffices
  bool help = false;
  bool version = false;
};

/// Throws UsageError.
CommandLine parse_command_line(int argc, const char* const* argv);

/// The text of --help.
std::string usage();

}  // namespace filmsticking::app
