// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "window.h"

namespace filmsticking::app {

/// The command line of mesh_view.
struct CommandLine {
  std::string mesh;       ///< empty: none
  std::string points;     ///< cloud; empty: none
  std::string steps;      ///< folder with an evolution, before the mesh; empty: none
  std::string reference;  ///< mesh to measure distances to; empty: none
  double range = 0;       ///< the distance at the end of the colours; 0: the program chooses
  WindowOptions window;
  bool help = false;
};

/// Throws UsageError.
CommandLine parse_command_line(int argc, const char* const* argv);

/// The text of --help.
std::string usage();

}  // namespace filmsticking::app
