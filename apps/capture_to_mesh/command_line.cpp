// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include "common/filter_arguments.h"
#include "common/reconstruction_arguments.h"
#include "stream/frame_source.h"

namespace filmsticking::app {
namespace {

void add_capture(Arguments& arguments, CommandLine& command) {
  arguments.group("Capture");
  arguments.option("--device", "NAME",
                   "a live OpenNI2 camera in place of the recording: its URI, '#1', or '' for any",
                   [&command](const std::string& name) { command.device = name; });
  arguments.count("--stride", "N", "use every Nth frame only", command.stride, 1);
  arguments.count("--frames", "N", "end after N frames", command.frames, 1);
  arguments.count("--every", "N",
                  "write a mesh every N frames while capturing, too; skip one while the last is not done",
                  command.every, 1);
}

void add_poses(Arguments& arguments, CommandLine& command) {
  arguments.group("Poses");
  arguments.option("--poses", "FILE",
                   "trajectory: lines 'time tx ty tz qx qy qz qw' (TUM RGB-D), sensor to world",
                   command.poses);
  arguments.choice(
      "--align", "auto|sensor|icp|gicp",
      "sensor: the pose in each PCD file; icp, gicp: fit each frame to the frames before it; auto (the "
      "default): sensor for frames that have a pose, gicp for the others",
      command.align,
      {{"auto", Align::Auto}, {"sensor", Align::Sensor}, {"icp", Align::Icp}, {"gicp", Align::Gicp}});
  arguments.positive("--min-overlap", "SHARE",
                     "icp, gicp: leave a frame out if less of it lies on the frames before it; default 0.35",
                     command.min_overlap, 1);
  arguments.option("--save-poses", "FILE", "write the poses found, in the same format", command.save_poses);
}

void add_fusion(Arguments& arguments, CommandLine& command) {
  arguments.group("Fusion");
  arguments.positive("--fuse", "LEAF",
                     "width of the cells in which frames are averaged; default 1.5 times the first frame's "
                     "mean distance between neighbours",
                     command.fuse);
  arguments.count("--seen-by", "N", "keep cells that at least N frames have hit; default 1", command.seen_by,
                  1);
  arguments.count("--max-points", "N", "beyond N cells they get twice as wide; default 1000000",
                  command.most_points, 1);
  arguments.option("--save-cloud", "FILE.ply", "write the fused cloud", command.save_cloud);
}

void add_options(Arguments& arguments, CommandLine& command) {
  arguments.only_flag("--help", "print this text", command.help);
  arguments.only_flag("--version", "print the version", command.version);
  arguments.flag("--double",
                 "write double coordinates; default: only where single precision does not tell points apart",
                 command.doubles);
  add_capture(arguments, command);
  add_poses(arguments, command);
  add_fusion(arguments, command);
  add_filters(arguments, command.filters);
  add_reconstruction(arguments, command.options);
}

void choose_files(const Arguments& given, CommandLine& command) {
  std::vector<std::string> files = given.files();
  if (command.device && files.size() != 1) throw UsageError("with --device, an OUTPUT alone is needed");
  if (!command.device && files.size() < 2)
    throw UsageError("a RECORDING and an OUTPUT are needed; see --help");
  for (const std::string& file : files)
    if (file.empty()) throw UsageError("a file has an empty name");
  command.output = files.back();
  files.pop_back();
  command.inputs = std::move(files);
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine command;
  Arguments arguments;
  add_options(arguments, command);
  if (!arguments.parse(argc, argv)) return command;
  choose_files(arguments, command);
  if (arguments.has("--poses")) {
    if (arguments.has("--align")) throw UsageError("--poses and --align exclude each other");
    command.align = Align::Poses;
  }
  return command;
}

std::string usage() {
  CommandLine command;
  Arguments arguments;
  add_options(arguments, command);
  const char* const openni =
      stream::has_openni() ? "This program can read .oni files and OpenNI2 cameras.\n"
                           : "This program's PCL was built without OpenNI2: no .oni files, no cameras.\n";
  return R"(usage: capture_to_mesh RECORDING OUTPUT [options]
       capture_to_mesh --device NAME OUTPUT [options]

Turns a scanner's capture into a closed manifold triangle mesh: frames are filtered, moved into one
coordinate system, averaged in cells of a grid, and meshed at the end. Ctrl-C ends the capture and
meshes the frames so far; a second one ends the program.
  RECORDING  a folder of .pcd, .ply, .las, .ptx, .pts or .xyz files (in the order of their names),
             such files one by one, or an .oni file of a depth camera. A number at the end of a
             file's name is its time; every station of a PTX file is a frame with its pose.
  OUTPUT     .ply .obj .stl .vtk .glb; with --open, what was seen, with borders
)" + arguments.help() +
         "\nThe filters crop, sor and voxel run on each frame, in the sensor's coordinates; mls runs on the "
         "fused cloud.\n" +
         openni + "Exit status: 0 with a mesh written, 2 for a wrong command line, else 1.\n";
}

}  // namespace filmsticking::app
