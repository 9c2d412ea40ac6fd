// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <sstream>

#include "common/arguments.h"
#include "common/view_arguments.h"
#include "io/files.h"

namespace filmsticking::app {
namespace {

constexpr int kLeastPixels = 100, kMostPixels = 8192;  // a side

void add_options(Arguments& arguments, CommandLine& command) {
  WindowOptions& window = command.window;
  arguments.only_flag("--help", "print this text", command.help);
  arguments.option("--points", "CLOUD", "show this cloud too", command.points);
  arguments.option("--steps", "DIR",
                   "an evolution, as pcd_to_mesh --dump-steps DIR writes it; MESH is its end", command.steps);
  arguments.option("--reference", "MESH", "measure the distance of the faces to this mesh",
                   command.reference);
  arguments.positive("--range", "D",
                     "distance at the end of the colours; default: a round one beyond 99 % of the distances "
                     "of the last mesh",
                     command.range);
  add_view(arguments, window.angles);
  add_size(arguments, "of the window in pixels; default 1000x750", kLeastPixels, kMostPixels, window.width,
           window.height);
  arguments.option("--screenshot", "FILE.png",
                   "what key j writes; default mesh_view.png, and mesh_view_2.png .. where that is there",
                   window.screenshot);
  arguments.option("--press", "KEYS",
                   "press keys when the window is open, as in --press \"End c j q\"; wait is a moment "
                   "without one",
                   [&window](const std::string& text) {
                     std::istringstream keys(text);
                     for (std::string key; keys >> key; window.keys.push_back(key))
                       if (!is_key(key) && key != kWait) throw UsageError("--press: there is no key " + key);
                   });
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine command;
  Arguments arguments;
  add_options(arguments, command);
  if (!arguments.parse(argc, argv)) return command;
  if (arguments.files().size() > 1)
    throw UsageError("one MESH at most is shown; mesh_snapshot draws several side by side");
  if (!arguments.files().empty()) command.mesh = arguments.files()[0];
  if (command.mesh.empty() && command.points.empty() && command.steps.empty())
    throw UsageError("a MESH, --points or --steps is needed; see --help");
  if (!command.reference.empty() && command.mesh.empty() && command.steps.empty())
    throw UsageError("--reference is for a MESH or --steps");
  if (io::extension_of(command.window.screenshot) != ".png")
    throw UsageError("the screenshot's name must end in .png");
  return command;
}

std::string usage() {
  CommandLine command;
  Arguments arguments;
  add_options(arguments, command);
  std::string text = R"(usage: mesh_view MESH [options]
       mesh_view [MESH] --points CLOUD [options]
       mesh_view [MESH] --steps DIR [options]

Shows a mesh in a window, with the points that it was made from, the film's steps to it, its holes, and
how far it is from a reference. Front faces are light, back faces and the edges of holes red, edges with
more than two faces violet. Distances go from pale yellow (zero) to blue (the end of the scale and beyond);
a face has the largest one of its corners and its middle.
  MESH   .ply .obj .stl .vtk
  CLOUD  .pcd .ply .obj .stl .xyz .txt (of a mesh, the vertices)
)" + arguments.help() +
                     "\nKeys, by the names that --press takes:\n";
  std::istringstream keys(key_help());
  for (std::string line; std::getline(keys, line);) text += "  " + line + '\n';
  return text + "\nExit status: 0 when the window was closed; 2 for a wrong command line, else 1.\n";
}

}  // namespace filmsticking::app
