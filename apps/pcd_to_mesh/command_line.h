// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "filmsticking/options.h"
#include "filters/filter_options.h"
#include "filters/ground_plane.h"

namespace filmsticking::app {

/// As the name of a file: standard input or output.
constexpr const char* kStandardStream = "-";

/// A cloud and the mesh to make of it.
struct Task {
  std::string input;
  std::string output;
  std::vector<std::string> more = {};  ///< further files of the same cloud
};

/// The largest hole to close: a length, or a share of the diagonal of the cloud's box.
struct MaxHole {
  double value = 0;
  bool is_share = false;
};

/// The command line of pcd_to_mesh.
struct CommandLine {
  std::vector<Task> tasks;
  bool batch = false;  ///< the program names the outputs, in `folder`
  std::string folder;  ///< of a batch
  std::string
      from;  ///< the format of the inputs; empty: by the name of a file, by the content of standard input
  std::string to = "ply";            ///< the format of standard output and of a batch
  std::vector<std::string> columns;  ///< names of the columns of texts; empty: by the text
  std::string report;                ///< JSON file; empty: none
  std::string points_out;            ///< file for the cloud with normals; empty: none
  std::string html;                  ///< file of the page; empty: none
  MaxHole max_hole;
  bool normals = false;    ///< of the vertices, in the mesh
  std::string dump_steps;  ///< folder for the film after each step; empty: none
  bool merge = false;      ///< all inputs are one cloud
  bool doubles = false;    ///< write double coordinates even where single precision tells the points apart
  int jobs = 1;            ///< tasks at a time
  filters::FilterOptions filters;
  filters::GroundChoice ground;
  Options options;
  bool help = false;
  bool version = false;
};

/// Throws UsageError.
CommandLine parse_command_line(int argc, const char* const* argv);

/// The text of --help.
std::string usage();

}  // namespace filmsticking::app
