// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <algorithm>
#include <boost/program_options.hpp>
#include <cmath>
#include <sstream>

#include "common/usage_error.h"
#include "io/files.h"
#include "scene/view_arguments.h"

namespace po = boost::program_options;

namespace filmsticking::app {
namespace {

constexpr int kPanelSize = 700;     // pixels
constexpr int kMostPixels = 16384;  // a side
constexpr int kMostTurns = 720;

po::options_description visible_options() {
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  po::options_description options("Options", 100);
  options.add_options()("output,o", text("OUT"), "the picture, .png; or an animation, .gif")(
      "size", text("WxH"), "size of the whole picture in pixels")("points", text("CLOUD"),
                                                                  "draw this cloud over every mesh")(
      "colours", "show the colours that the files have")("reference", text("MESH"),
                                                         "paint the faces by their distance to this mesh")(
      "deviation", "paint the points by their distance to the mesh")(
      "range", po::value<double>()->value_name("D"),
      "distance at the end of the colours; default: a round one beyond 99 % of those that occur")(
      "steps", text("DIR"), "an evolution, as pcd_to_mesh --dump-steps DIR writes it: one picture a step")(
      "turntable", po::value<int>()->value_name("N"),
      "a full turn around the upright axis in N pictures, 2 to 720")(
      "fps", po::value<double>()->value_name("R"), "pictures a second of a .gif, 1 to 50; default 12")(
      "view", text("AZ,EL"), "degrees: around the upright axis, and above the horizon; default 30,20")(
      "up", text("y|z"), "the upright axis; default y")("edges", "draw the edges of the triangles")(
      "grey-backs", "paint back faces grey, so that only the edges of holes are red")(
      "columns", po::value<int>()->value_name("N"), "panels in a row; default up to 4")(
      "labels", "write the file's name under every mesh")(
      "label", po::value<std::vector<std::string>>()->value_name("TEXT"),
      "write a text under a panel; once for every panel, in their order")(
      "fit", text("all|row|each"),
      "what shares one scale and middle: all meshes (default), those of a row, or none")("help",
                                                                                         "print this text");
  return options;
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
    // Without guessing; a short option only as "-o OUT.png", so that a negative angle is no option.
    const int style = allow_long | long_allow_adjacent | long_allow_next | allow_short |
                      allow_dash_for_short | short_allow_next;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
              given);
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }

  CommandLine command;
  command.help = given.count("help") > 0;
  if (command.help) return command;
  if (given.count("mesh")) command.meshes = given["mesh"].as<std::vector<std::string>>();
  if (given.count("steps")) command.steps = given["steps"].as<std::string>();
  const int panels = static_cast<int>(command.meshes.size()) + (command.steps.empty() ? 0 : 1);
  if (panels == 0) throw UsageError("a mesh is needed, or --steps; --help tells more");
  if (!given.count("output")) throw UsageError("-o OUT.png is needed; --help tells more");
  command.output = given["output"].as<std::string>();
  const std::string extension = io::extension_of(command.output);
  if (extension != ".png" && extension != ".gif")
    throw UsageError("the picture's name must end in .png or .gif");
  if (given.count("points")) command.points = given["points"].as<std::string>();
  command.labels = given.count("labels") > 0;
  if (given.count("label")) command.captions = given["label"].as<std::vector<std::string>>();
  if (!command.captions.empty() && static_cast<int>(command.captions.size()) != panels)
    throw UsageError("--label is needed once for every panel, or not at all");

  if (given.count("reference")) command.reference = given["reference"].as<std::string>();
  command.deviation = given.count("deviation") > 0;
  if (command.deviation && command.points.empty()) throw UsageError("--deviation is for --points");
  if (given.count("range")) {
    command.range = given["range"].as<double>();
    if (!(command.range > 0) || !std::isfinite(command.range))
      throw UsageError("--range takes a distance above zero");
    if (command.reference.empty() && !command.deviation)
      throw UsageError("--range is for --reference and --deviation");
  }
  if (given.count("turntable")) {
    command.turns = given["turntable"].as<int>();
    if (command.turns < 2 || command.turns > kMostTurns)
      throw UsageError("--turntable takes a whole number from 2 to " + std::to_string(kMostTurns));
  }
  if (given.count("fps")) {
    command.pictures_per_second = given["fps"].as<double>();
    if (!(command.pictures_per_second >= 1 && command.pictures_per_second <= 50))
      throw UsageError("--fps takes a number from 1 to 50");
  }

  View& view = command.view;
  view.style.edges = given.count("edges") > 0;
  view.style.grey_backs = given.count("grey-backs") > 0;
  view.style.colours = given.count("colours") > 0;
  view.columns = given.count("columns") ? given["columns"].as<int>() : std::min(panels, 4);
  if (view.columns < 1) throw UsageError("--columns takes a whole number from 1 on");
  view.columns = std::min(view.columns, panels);
  view.width = kPanelSize * view.columns;
  view.height = kPanelSize * ((panels + view.columns - 1) / view.columns);
  if (given.count("size"))
    scene::parse_size(given["size"].as<std::string>(), 16, kMostPixels, view.width, view.height);
  if (given.count("view")) scene::parse_view(given["view"].as<std::string>(), view.angles);
  if (given.count("up")) scene::parse_up(given["up"].as<std::string>(), view.angles);
  if (given.count("fit")) {
    const std::string fit = given["fit"].as<std::string>();
    if (fit != "all" && fit != "row" && fit != "each") throw UsageError("--fit takes all, row or each");
    view.fit = fit == "all" ? Fit::All : fit == "row" ? Fit::Row : Fit::Each;
  }
  return command;
}

std::string usage() {
  std::ostringstream text;
  text << "usage: mesh_snapshot MESH.. -o OUT.png [options]\n"
          "       mesh_snapshot [MESH..] --steps DIR -o OUT.gif [options]\n\n"
          "Draws meshes (.ply .obj .stl .vtk) side by side, all from the same view. Front faces are light, "
          "back\n"
          "faces and the edges of holes red, edges with more than two faces violet. A MESH \"-\" leaves its "
          "place\n"
          "empty. It needs an X display:\n"
          "on a machine without one run it as  xvfb-run -a mesh_snapshot ..\n\n"
          "With --turntable or --steps there are several pictures: OUT.gif is an animation, and OUT.png "
          "stands for\n"
          "OUT_000.png, OUT_001.png ... With both, the evolution goes on during one turn. --steps takes the "
          "first\n"
          "place, before the meshes.\n\n"
          "Distances are painted pale yellow (zero), green, blue (the end of the scale and beyond), grey "
          "where there\n"
          "is none, on both sides of a face; a face has the largest one of its corners and its middle.\n\n"
       << visible_options()
       << "\nExit status: 0 with all pictures written; 2 for a wrong command line, else 1.\n";
  return text.str();
}

}  // namespace filmsticking::app
