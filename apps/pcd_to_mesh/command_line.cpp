// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <thread>

#include "common/filter_arguments.h"
#include "common/ground_argument.h"
#include "common/html_argument.h"
#include "common/reconstruction_arguments.h"
#include "filters/filter_options.h"
#include "io/formats.h"

namespace fs = std::filesystem;

namespace filmsticking::app {
namespace {

/// One of the formats.
void add_format(Arguments& arguments, const std::string& name, const std::string& help, std::string& format,
                const std::vector<std::string>& formats) {
  std::vector<Choice<std::string>> choices;
  choices.reserve(formats.size());
  for (const std::string& each : formats) choices.push_back({each, each});
  arguments.choice(name, "FORMAT", help, format, choices);
}

MaxHole parse_max_hole(const std::string& text) {
  const bool is_share = !text.empty() && text.back() == '%';
  const std::vector<double> numbers =
      filters::parse_numbers(text.substr(0, text.size() - (is_share ? 1 : 0)));
  if (numbers.size() != 1 || !(numbers[0] > 0) || !std::isfinite(numbers[0]))
    throw UsageError("--close-holes takes a length or a percentage above 0, not '" + text + "'");
  return {is_share ? numbers[0] / 100 : numbers[0], is_share};
}

std::vector<std::string> column_names(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream words(text);
  for (std::string name; std::getline(words, name, ',');) {
    if (name.empty()) throw UsageError("--columns takes names as x,y,z,_,r,g,b, not '" + text + "'");
    names.push_back(name);
  }
  if (names.size() < 3) throw UsageError("--columns takes three names at least, as x,y,z");
  return names;
}

void add_options(Arguments& arguments, CommandLine& command) {
  arguments.only_flag("--help", "print this text", command.help);
  arguments.only_flag("--version", "print the version", command.version);
  arguments.option("--out-dir", "FOLDER", "all files are inputs; their meshes go there", command.folder);
  add_format(arguments, "--to",
             "format of the meshes in a folder or on standard output: ply (the default), obj, stl, vtk, glb",
             command.to, io::mesh_formats());
  std::string formats;
  for (const std::string& format : io::cloud_formats()) formats += (formats.empty() ? "" : ", ") + format;
  add_format(arguments, "--format", "format of the input, where its content does not say it: " + formats,
             command.from, io::cloud_formats());
  arguments.option("--columns", "NAMES", "columns of a text, as x,y,z,_,r,g,b; '_' is left out",
                   [&command](const std::string& names) { command.columns = column_names(names); });
  arguments.flag("--merge", "all inputs, of any formats, are one cloud", command.merge);
  arguments.flag("--double",
                 "write double coordinates; default: only where single precision does not tell points apart",
                 command.doubles);
  arguments.count("--jobs", "N",
                  "clouds at a time, where there are several; 0: as many as processors; default 1",
                  command.jobs, 0);
  arguments.option("--report", "FILE.json", "write what was done as JSON; of several inputs, a list",
                   command.report);
  add_html(arguments, "write a page to look at the mesh and its points, without a network; of one input",
           command.html);
  arguments.option("--dump-steps", "DIR", "write the film after each step as PLY", command.dump_steps);
  arguments.flag("--normals", "give the mesh's vertices unit normals; the mesh must be a .ply",
                 command.normals);
  arguments.option("--points-out", "FILE",
                   "write the points, also those that are no vertices, with unit normals oriented by the "
                   "surface: .ply .pcd .xyz .txt",
                   command.points_out);
  arguments.flag("--stability",
                 "colour the mesh from white to red where the points alone do not tell inside from outside",
                 command.options.stability);
  arguments.option(
      "--close-holes", "LENGTH|PERCENT",
      "as --open, but close holes of at most this diameter, in the cloud's unit or, with %, of its "
      "box's diagonal",
      [&command](const std::string& text) { command.max_hole = parse_max_hole(text); });
  add_filters(arguments, command.filters);
  add_ground(
      arguments,
      "close what stands on the ground with it: after the other filters, leave the ground's points out and "
      "add points on its plane; the plane with the most points, or Ax + By + Cz + D = 0, (A, B, C) up",
      command.ground);
  add_reconstruction(arguments, command.options);
}

bool names_folder(const std::string& path) {
  std::error_code error;
  return path.back() == '/' || fs::is_directory(path, error);
}

/// The meshes' names in the folder; two clouds must not become the same.
std::vector<Task> tasks_of(const std::vector<std::string>& inputs, const std::string& folder,
                           const std::string& format) {
  std::vector<Task> tasks;
  std::map<std::string, std::string> input_of;
  for (const std::string& input : inputs) {
    if (input == kStandardStream) throw UsageError("standard input has no name for a mesh in a folder");
    const std::string name = fs::path(input).stem().string() + "." + format;
    const auto [other, is_new] = input_of.emplace(name, input);
    if (!is_new) throw UsageError(other->second + " and " + input + " would both become " + name);
    tasks.push_back({input, (fs::path(folder) / name).string()});
  }
  return tasks;
}

void choose_files(const Arguments& given, CommandLine& command) {
  std::vector<std::string> files = given.files();
  for (const std::string& file : files)
    if (file.empty()) throw UsageError("a file has an empty name");
  const bool named = given.has("--out-dir");
  if (named && files.empty()) throw UsageError("an INPUT is needed; see --help");
  if (!named && files.size() < 2) throw UsageError("an INPUT and an OUTPUT are needed; see --help");
  if (!named) {
    command.folder = files.back();
    files.pop_back();
  }
  if (command.folder.empty()) throw UsageError("--out-dir takes a folder");
  command.batch = !command.merge && (named || names_folder(command.folder));
  if (command.merge) {
    if (named) throw UsageError("--merge makes one mesh, and takes no --out-dir");
    command.tasks = {{files[0], command.folder, {files.begin() + 1, files.end()}}};
    if (std::count(files.begin(), files.end(), kStandardStream) > 1)
      throw UsageError("standard input is given twice");
    return;
  }

  if (command.batch) {
    command.tasks = tasks_of(files, command.folder, command.to);
    if (!command.dump_steps.empty() && files.size() > 1)
      throw UsageError("--dump-steps takes one input only");
    if (!command.points_out.empty() && files.size() > 1)
      throw UsageError("--points-out takes one input only");
    if (!command.html.empty() && files.size() > 1) throw UsageError("--html takes one input only");
    return;
  }
  if (files.size() > 1)
    throw UsageError("several inputs need a folder, and '" + command.folder +
                     "' is none; end it with '/', or make one cloud of them with --merge");
  command.tasks = {{files[0], command.folder}};
  if (given.has("--to") && command.folder != kStandardStream)
    throw UsageError("--to is for folders and standard output; the name of a file says its format");
}

/// Shares the processors out to the tasks.
void choose_jobs(CommandLine& command) {
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (command.jobs == 0) command.jobs = processors;
  command.jobs = std::min(command.jobs, static_cast<int>(command.tasks.size()));
  if (command.options.threads == 0 && command.jobs > 1)  // with more, tasks would wait for each other
    command.options.threads = std::max(1, processors / command.jobs);
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine command;
  Arguments arguments;
  add_options(arguments, command);
  if (!arguments.parse(argc, argv)) return command;
  if (command.ground.asked && command.options.open_boundary)
    throw UsageError("--ground closes the surface and --open leaves it open");
  choose_files(arguments, command);
  choose_jobs(command);
  return command;
}

std::string usage() {
  CommandLine command;
  Arguments arguments;
  add_options(arguments, command);
  return R"(usage: pcd_to_mesh INPUT OUTPUT [options]
       pcd_to_mesh INPUT.. FOLDER/ [options]
       pcd_to_mesh --out-dir FOLDER INPUT.. [options]
       pcd_to_mesh INPUT.. OUTPUT --merge [options]

Turns point clouds without normals into closed manifold triangle meshes through their points; with
--open, into meshes of what was seen, with borders.
  INPUT   PCD, PLY, OBJ, STL, VTK, OFF (of a mesh, the vertices), LAS, PTX, or text with a point a
          line (XYZ, CSV, PTS, ..), whatever its name; - for standard input
  OUTPUT  .ply (binary) .obj .stl .vtk .glb, or - for standard output; coordinates are double where
          single precision does not tell the points apart, colours go into all but .stl
  FOLDER  takes a mesh for every INPUT, by its name; the program makes it if it is not there.
          An input that fails does not stop the others.
)" + arguments.help() +
         "\nExit status: 0 with every mesh written, 2 for a wrong command line, 130 if interrupted, else "
         "1.\n";
}

}  // namespace filmsticking::app
