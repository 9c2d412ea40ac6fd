// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sheet.h"

namespace filmsticking::app {

/// As the name of a mesh: none.
constexpr char kNoMesh[] = "-";

/// The command line of mesh_snapshot.
struct CommandLine {
  std::vector<std::string> meshes;    ///< kNoMesh: an empty panel
  std::string steps;                  ///< folder with an evolution, a panel before the meshes; empty: none
  std::string points;                 ///< cloud to draw over every mesh; empty: none
  std::string reference;              ///< mesh to paint the faces by their distance to; empty: none
  bool deviation = false;             ///< paint the points by their distance to the mesh
  double range = 0;                   ///< the distance at the end of the colours; 0: the program chooses
  int turns = 1;                      ///< pictures of a turn; 1: none
  double pictures_per_second = 12;    ///< of an animation
  std::string output;                 ///< .png or .gif
  bool labels = false;                ///< the names of the files
  std::vector<std::string> captions;  ///< texts instead, one a mesh; empty: none
  View view;
  bool help = false;
};

/// Throws UsageError.
CommandLine parse_command_line(int argc, const char* const* argv);

/// The text of --help.
std::string usage();

}  // namespace filmsticking::app
