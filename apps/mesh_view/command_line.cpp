// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <boost/program_options.hpp>
#include <sstream>

#include "common/arguments.h"
#include "io/files.h"
#include "scene/view_arguments.h"

namespace po = boost::program_options;

namespace filmsticking::app {
namespace {

constexpr int kLeastPixels = 100, kMostPixels = 8192;  // a side

po::options_description visible_options() {
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  po::options_description options("Options", 100);
  options.add_options()("points", text("CLOUD"), "show this cloud too")(
      "steps", text("DIR"), "an evolution, as pcd_to_mesh --dump-steps DIR writes it; MESH is its end")(
      "reference", text("MESH"), "measure the distance of the faces to this mesh")(
      "range", text("D"),
      "distance at the end of the colours; default: a round one beyond 99 % of those of the last mesh")(
      "view", text("AZ,EL"), "degrees: around the upright axis, and above the horizon; default 30,20")(
      "up", text("y|z"), "the upright axis; default y")("size", text("WxH"),
                                                        "of the window in pixels; default 1000x750")(
      "screenshot", text("FILE.png"),
      "what key j writes; default mesh_view.png, and mesh_view_2.png .. where that is there")(
      "press", text("KEYS"),
      "press keys when the window is open, as in --press \"End c j q\"; wait is a moment without one")(
      "help", "print this text");
  return options;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  const Arguments given(argc, argv, visible_options());
  CommandLine command;
  command.help = given.has("help");
  if (command.help) return command;
  if (given.files().size() > 1)
    throw UsageError("one MESH at most is shown; mesh_snapshot draws several side by side");
  if (!given.files().empty()) command.mesh = given.files()[0];
  command.points = given.text("points");
  command.steps = given.text("steps");
  if (command.mesh.empty() && command.points.empty() && command.steps.empty())
    throw UsageError("a MESH, --points or --steps is needed; --help tells more");
  command.reference = given.text("reference");
  if (!command.reference.empty() && command.mesh.empty() && command.steps.empty())
    throw UsageError("--reference is for a MESH or --steps");
  if (given.has("range")) command.range = parse_positive("range", given.text("range"));

  WindowOptions& window = command.window;
  if (given.has("view")) scene::parse_view(given.text("view"), window.angles);
  if (given.has("up")) scene::parse_up(given.text("up"), window.angles);
  if (given.has("size"))
    scene::parse_size(given.text("size"), kLeastPixels, kMostPixels, window.width, window.height);
  if (given.has("screenshot")) window.screenshot = given.text("screenshot");
  if (io::extension_of(window.screenshot) != ".png")
    throw UsageError("the screenshot's name must end in .png");
  std::istringstream keys(given.text("press"));
  for (std::string key; keys >> key; window.keys.push_back(key))
    if (!is_key(key) && key != kWait) throw UsageError("--press: there is no key " + key);
  return command;
}

std::string usage() {
  std::ostringstream out;
  out << "usage: mesh_view MESH [options]\n"
         "       mesh_view [MESH] --points CLOUD [options]\n"
         "       mesh_view [MESH] --steps DIR [options]\n\n"
         "Shows a mesh in a window, with the points that it was made from, the film's steps to it, its "
         "holes, "
         "and\n"
         "how far it is from a reference. Front faces are light, back faces and the edges of holes red, "
         "edges "
         "with\n"
         "more than two faces violet. Distances go from pale yellow (zero) to blue (the end of the scale and "
         "beyond);\n"
         "a face has the largest one of its corners and its middle.\n"
         "  MESH   .ply .obj .stl .vtk\n"
         "  CLOUD  .pcd .ply .obj .stl .xyz .txt (of a mesh, the vertices)\n\n"
      << visible_options() << "\nKeys, by the names that --press takes:\n";
  std::istringstream keys(key_help());
  for (std::string line; std::getline(keys, line);) out << "  " << line << '\n';
  out << "\nExit status: 0 when the window was closed; 2 for a wrong command line, else 1.\n";
  return out.str();
}

}  // namespace filmsticking::app
