// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <sstream>

#include "common/filter_arguments.h"
#include "common/reconstruction_arguments.h"
#include "stream/frame_source.h"

namespace po = boost::program_options;

namespace filmsticking::app {
namespace {

po::options_description visible_options() {
  po::options_description capture("Capture", 100);
  capture.add_options()("device", po::value<std::string>()->value_name("NAME"),
                        "a live OpenNI2 camera in place of the recording: its URI, '#1', or '' for any")(
      "stride", po::value<std::string>()->value_name("N"), "use every Nth frame only")(
      "frames", po::value<std::string>()->value_name("N"), "end after N frames")(
      "every", po::value<std::string>()->value_name("N"),
      "write a mesh every N frames while capturing, too; one is skipped if the last is still at work");
  po::options_description poses("Poses", 100);
  poses.add_options()("poses", po::value<std::string>()->value_name("FILE"),
                      "trajectory: lines 'time tx ty tz qx qy qz qw' (TUM RGB-D), sensor to world")(
      "align", po::value<std::string>()->value_name("auto|sensor|icp|gicp"),
      "sensor: the pose in each PCD file; icp, gicp: fit each frame to those before it; auto (the default): "
      "sensor for frames that have a pose, gicp for the others")(
      "min-overlap", po::value<std::string>()->value_name("SHARE"),
      "icp, gicp: leave a frame out if less of it lies on those before it; default 0.35")(
      "save-poses", po::value<std::string>()->value_name("FILE"),
      "write the poses found, in the same format");
  po::options_description fusion("Fusion", 100);
  fusion.add_options()("fuse", po::value<std::string>()->value_name("LEAF"),
                       "width of the cells in which frames are averaged; default 1.5 times the first frame's "
                       "mean distance between neighbours")(
      "seen-by", po::value<std::string>()->value_name("N"),
      "keep cells that at least N frames have hit; default 1")(
      "max-points", po::value<std::string>()->value_name("N"),
      "beyond N cells they get twice as wide; default 1000000")(
      "save-cloud", po::value<std::string>()->value_name("FILE.ply"), "write the fused cloud");
  po::options_description options("Options", 100);
  options.add_options()("help", "print this text")("version", "print the version");
  return options.add(capture).add(poses).add(fusion).add(filter_arguments()).add(reconstruction_arguments());
}

void choose_files(const Arguments& given, CommandLine& command) {
  std::vector<std::string> files = given.files();
  if (given.has("device")) command.device = given.text("device");
  if (command.device && files.size() != 1) throw UsageError("with --device, an OUTPUT alone is needed");
  if (!command.device && files.size() < 2)
    throw UsageError("a RECORDING and an OUTPUT are needed; --help tells more");
  for (const std::string& file : files)
    if (file.empty()) throw UsageError("a file has an empty name");
  command.output = files.back();
  files.pop_back();
  command.inputs = std::move(files);
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  const Arguments given(argc, argv, visible_options());
  CommandLine command;
  command.help = given.has("help");
  command.version = given.has("version");
  if (command.help || command.version) return command;
  choose_files(given, command);
  command.poses = given.text("poses");
  command.save_poses = given.text("save-poses");
  command.save_cloud = given.text("save-cloud");
  given.with("align", [&](const auto& name, const auto& text) {
    command.align = parse_choice<Align>(
        name, text,
        {{"auto", Align::Auto}, {"sensor", Align::Sensor}, {"icp", Align::Icp}, {"gicp", Align::Gicp}});
  });
  if (given.has("poses")) {
    if (given.has("align")) throw UsageError("--poses and --align exclude each other");
    command.align = Align::Poses;
  }
  given.with("fuse", [&](const auto& name, const auto& text) { command.fuse = parse_positive(name, text); });
  given.with("min-overlap", [&](const auto& name, const auto& text) {
    command.min_overlap = parse_positive(name, text);
    if (command.min_overlap > 1) throw UsageError("--min-overlap takes a share up to 1, not '" + text + "'");
  });
  const auto count = [&](const char* option, int least, int& value) {
    given.with(option, [&](const auto& name, const auto& text) { value = parse_count(name, text, least); });
  };
  count("seen-by", 1, command.seen_by);
  count("max-points", 1, command.most_points);
  count("every", 1, command.every);
  count("stride", 1, command.stride);
  count("frames", 1, command.frames);
  command.filters = filter_options(given);
  command.options = reconstruction_options(given);
  return command;
}

std::string usage() {
  std::ostringstream text;
  text
      << "usage: capture_to_mesh RECORDING OUTPUT [options]\n"
         "       capture_to_mesh --device NAME OUTPUT [options]\n\n"
         "Turns a scanner's capture into a closed manifold triangle mesh: frames are filtered, brought into\n"
         "one coordinate system, averaged in cells of a grid, and meshed at the end. Ctrl-C ends the "
         "capture\n"
         "and meshes what there is; a second one ends the program.\n"
         "  RECORDING  a folder of .pcd files (in the order of their names), .pcd files one by one, or an\n"
         "             .oni file of a depth camera. A number at the end of a PCD file's name is its time.\n"
         "  OUTPUT     .ply .obj .stl .vtk .glb; with --open, what was seen, with borders\n\n"
      << visible_options()
      << "\nThe filters crop, sor and voxel run on each frame, in the sensor's coordinates; mls runs on the "
         "fused cloud.\n"
      << (stream::has_openni()
              ? "This program can read .oni files and OpenNI2 cameras.\n"
              : "This program's PCL was built without OpenNI2: no .oni files, no cameras.\n")
      << "Exit status: 0 with a mesh written, 2 for a wrong command line, else 1.\n";
  return text.str();
}

}  // namespace filmsticking::app
