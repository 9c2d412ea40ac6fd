// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "scene.h"

namespace filmsticking::app {

/// Stands for a mesh that there is not.
constexpr char kNoMesh[] = "-";

/// What the user asked mesh_snapshot for.
struct CommandLine {
  std::vector<std::string> meshes;  ///< kNoMesh: an empty panel
  std::string points;               ///< cloud to draw over every mesh; empty: none
  std::string output;
  bool labels = false;                ///< the names of the files
  std::vector<std::string> captions;  ///< texts instead, one a mesh; empty: none
  View view;
  bool help = false;
};

/// A command line that makes no sense; what() is a sentence for the user.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws UsageError.
CommandLine parse_command_line(int argc, const char* const* argv);

/// The text of --help.
std::string usage();

}  // namespace filmsticking::app
