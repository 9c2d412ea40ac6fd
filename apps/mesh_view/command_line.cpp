// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <boost/program_options.hpp>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <vector>

#include "io/files.h"

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
      "range", po::value<double>()->value_name("D"),
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

/// "A<separator>B" as two numbers.
bool parse_pair(const std::string& text, char separator, double& a, double& b) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  char between = 0;
  return stream >> a >> between >> b && between == separator && stream.peek() == EOF;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  po::options_description all = visible_options();
  all.add_options()("mesh", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("mesh", -1);
  po::variables_map given;
  try {
    using namespace po::command_line_style;
    const int style = allow_long | long_allow_adjacent | long_allow_next;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
              given);
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }

  CommandLine command;
  command.help = given.count("help") > 0;
  if (command.help) return command;
  const auto text = [&](const char* name) {
    return given.count(name) ? given[name].as<std::string>() : std::string();
  };
  if (given.count("mesh")) {
    if (given["mesh"].as<std::vector<std::string>>().size() > 1)
      throw UsageError("one MESH at most is shown; mesh_snapshot draws several side by side");
    command.mesh = given["mesh"].as<std::vector<std::string>>()[0];
  }
  command.points = text("points");
  command.steps = text("steps");
  if (command.mesh.empty() && command.points.empty() && command.steps.empty())
    throw UsageError("a MESH, --points or --steps is needed; --help tells more");
  command.reference = text("reference");
  if (!command.reference.empty() && command.mesh.empty() && command.steps.empty())
    throw UsageError("--reference is for a MESH or --steps");
  if (given.count("range")) {
    command.range = given["range"].as<double>();
    if (!(command.range > 0) || !std::isfinite(command.range))
      throw UsageError("--range takes a distance above zero");
  }

  WindowOptions& window = command.window;
  if (given.count("view") &&
      (!parse_pair(text("view"), ',', window.angles.azimuth, window.angles.elevation) ||
       !std::isfinite(window.angles.azimuth) || !(std::abs(window.angles.elevation) <= 90)))
    throw UsageError("--view takes two angles in degrees like 30,20, the second from -90 to 90");
  if (given.count("up")) {
    if (text("up") != "y" && text("up") != "z") throw UsageError("--up takes y or z");
    window.angles.z_up = text("up") == "z";
  }
  if (given.count("size")) {
    double width = 0, height = 0;
    if (!parse_pair(text("size"), 'x', width, height) ||
        !(width >= kLeastPixels && height >= kLeastPixels && width <= kMostPixels && height <= kMostPixels))
      throw UsageError("--size takes pixels like 1200x800, from " + std::to_string(kLeastPixels) + " to " +
                       std::to_string(kMostPixels));
    window.width = static_cast<int>(width);
    window.height = static_cast<int>(height);
  }
  if (given.count("screenshot")) window.screenshot = text("screenshot");
  if (io::extension_of(window.screenshot) != ".png")
    throw UsageError("the screenshot's name must end in .png");
  std::istringstream keys(text("press"));
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
