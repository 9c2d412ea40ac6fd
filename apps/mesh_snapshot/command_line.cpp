// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <algorithm>

#include "common/arguments.h"
#include "common/view_arguments.h"
#include "io/files.h"

namespace filmsticking::app {
namespace {

constexpr int kPanelSize = 700;                        // pixels
constexpr int kLeastPixels = 16, kMostPixels = 16384;  // a side
constexpr int kMostTurns = 720;
constexpr int kMostColumns = 4;  // unless the user asks for more
constexpr double kLeastRate = 1, kMostRate = 50;

void add_painting(Arguments& arguments, CommandLine& command) {
  arguments.option("--points", "CLOUD", "draw this cloud over every mesh", command.points);
  arguments.flag("--colours", "show the colours that the files have", command.view.style.colours);
  arguments.option("--reference", "MESH", "paint the faces by their distance to this mesh",
                   command.reference);
  arguments.flag("--deviation", "paint the points by their distance to the mesh", command.deviation);
  arguments.positive("--range", "D",
                     "distance at the end of the colours; default: a round one beyond 99 % of the distances",
                     command.range);
  arguments.flag("--edges", "draw the edges of the triangles", command.view.style.edges);
  arguments.flag("--grey-backs", "paint back faces grey, so that only the edges of holes are red",
                 command.view.style.grey_backs);
}

void add_pictures(Arguments& arguments, CommandLine& command) {
  arguments.option("--steps", "DIR",
                   "an evolution, as pcd_to_mesh --dump-steps DIR writes it: one picture a step",
                   command.steps);
  arguments.count("--turntable", "N", "a full turn around the upright axis in N pictures, 2 to 720",
                  command.turns, 2, kMostTurns);
  arguments.number("--fps", "R", "pictures a second of a .gif, 1 to 50; default 12",
                   command.pictures_per_second, kLeastRate, kMostRate);
}

void add_layout(Arguments& arguments, CommandLine& command) {
  View& view = command.view;
  add_size(arguments, "size of the whole picture in pixels", kLeastPixels, kMostPixels, view.width,
           view.height);
  add_view(arguments, view.angles);
  arguments.count("--columns", "N", "panels in a row; default up to 4", view.columns, 1);
  arguments.flag("--labels", "write the file's name under every mesh", command.labels);
  arguments.repeatable("--label", "TEXT", "write a text under a panel; once for every panel, in their order",
                       command.captions);
  arguments.choice<Fit>(
      "--fit", "all|row|each",
      "what shares one scale and middle: all meshes (default), the meshes of a row, or none", view.fit,
      {{"all", Fit::All}, {"row", Fit::Row}, {"each", Fit::Each}});
}

void add_options(Arguments& arguments, CommandLine& command) {
  arguments.only_flag("--help", "print this text", command.help);
  arguments.option("-o,--output", "OUT", "the picture, .png; or an animation, .gif", command.output);
  add_painting(arguments, command);
  add_pictures(arguments, command);
  add_layout(arguments, command);
}

int panels_of(const CommandLine& command) {
  return static_cast<int>(command.meshes.size()) + (command.steps.empty() ? 0 : 1);
}

/// Throws UsageError for options that do not go together.
void check(const Arguments& given, const CommandLine& command) {
  if (panels_of(command) == 0) throw UsageError("a mesh is needed, or --steps; see --help");
  if (!given.has("--output")) throw UsageError("-o OUT.png is needed; see --help");
  const std::string extension = io::extension_of(command.output);
  if (extension != ".png" && extension != ".gif")
    throw UsageError("the picture's name must end in .png or .gif");
  if (!command.captions.empty() && static_cast<int>(command.captions.size()) != panels_of(command))
    throw UsageError("--label is needed once for every panel, or not at all");
  if (command.deviation && command.points.empty()) throw UsageError("--deviation is for --points");
  if (command.range > 0 && command.reference.empty() && !command.deviation)
    throw UsageError("--range is for --reference and --deviation");
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine command;
  Arguments arguments;
  add_options(arguments, command);
  if (!arguments.parse(argc, argv)) return command;
  command.meshes = arguments.files();
  check(arguments, command);

  View& view = command.view;
  const int panels = panels_of(command);
  view.columns = std::min(arguments.has("--columns") ? view.columns : kMostColumns, panels);
  if (!arguments.has("--size")) {
    view.width = kPanelSize * view.columns;
    view.height = kPanelSize * ((panels + view.columns - 1) / view.columns);
  }
  return command;
}

std::string usage() {
  CommandLine command;
  Arguments arguments;
  add_options(arguments, command);
  return R"(usage: mesh_snapshot MESH.. -o OUT.png [options]
       mesh_snapshot [MESH..] --steps DIR -o OUT.gif [options]

Draws meshes (.ply .obj .stl .vtk) side by side, all from the same view. Front faces are light, back
faces and the edges of holes red, edges with more than two faces violet. A MESH "-" leaves its place
empty. It needs an X display; on a machine without one run it as  xvfb-run -a mesh_snapshot ..

With --turntable or --steps there are several pictures: OUT.gif is an animation, and OUT.png stands for
OUT_000.png, OUT_001.png ... With both, the evolution goes on during one turn. --steps takes the first
place, before the meshes.

Distances are painted pale yellow (zero), green, blue (the end of the scale and beyond), grey where
there is none, on both sides of a face; a face has the largest one of its corners and its middle.
)" + arguments.help() +
         "\nExit status: 0 with all pictures written; 2 for a wrong command line, else 1.\n";
}

}  // namespace filmsticking::app
