// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <thread>

#include "common/filter_arguments.h"
#include "common/reconstruction_arguments.h"
#include "io/format.h"

namespace fs = std::filesystem;
namespace po = boost::program_options;

namespace filmsticking::app {
namespace {

po::options_description visible_options() {
  po::options_description options("Options", 100);
  options.add_options()("out-dir", po::value<std::string>()->value_name("FOLDER"),
                        "all files are inputs; their meshes go there")(
      "to", po::value<std::string>()->value_name("FORMAT"),
      "format of the meshes in a folder or on standard output: ply (the default), obj, stl, vtk, glb")(
      "format", po::value<std::string>()->value_name("FORMAT"),
      "format of the input, whatever its name: pcd, ply, obj, stl, xyz, txt")(
      "jobs", po::value<std::string>()->value_name("N"),
      "clouds at a time, where there are several; 0: as many as processors; default 1")(
      "report", po::value<std::string>()->value_name("FILE.json"),
      "write what was done as JSON; of several inputs, a list")(
      "dump-steps", po::value<std::string>()->value_name("DIR"), "write the film after each step as PLY")(
      "help", "print this text")("version", "print the version");
  return options.add(filter_arguments()).add(reconstruction_arguments());
}

/// One of the formats. Throws UsageError.
std::string parse_format(const std::string& option, const std::string& text,
                         const std::vector<std::string>& formats) {
  std::vector<Choice<std::string>> choices;
  choices.reserve(formats.size());
  for (const std::string& format : formats) choices.push_back({format.c_str(), format});
  return parse_choice(option, text, choices);
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
    if (!is_new)
      throw UsageError(std::string(other->second)
                           .append(" and ")
                           .append(input)
                           .append(" would both become ")
                           .append(name));
    tasks.push_back({input, (fs::path(folder) / name).string()});
  }
  return tasks;
}

void choose_files(const Arguments& given, CommandLine& command) {
  std::vector<std::string> files = given.files();
  for (const std::string& file : files)
    if (file.empty()) throw UsageError("a file has an empty name");
  const bool named = given.has("out-dir");
  if (named && files.empty()) throw UsageError("an INPUT is needed; --help tells more");
  if (!named && files.size() < 2) throw UsageError("an INPUT and an OUTPUT are needed; --help tells more");
  command.folder = named ? given.text("out-dir") : files.back();
  if (command.folder.empty()) throw UsageError("--out-dir takes a folder");
  command.batch = named || names_folder(command.folder);
  if (!named) files.pop_back();

  if (command.batch) {
    command.tasks = tasks_of(files, command.folder, given.has("to") ? command.to : "ply");
    if (!command.dump_steps.empty() && files.size() > 1)
      throw UsageError("--dump-steps takes one input only");
    return;
  }
  if (files.size() > 1)
    throw UsageError("several inputs need a folder, and '" + command.folder + "' is none; end it with '/'");
  command.tasks = {{files[0], command.folder}};
  if (given.has("to") && command.folder != kStandardStream)
    throw UsageError("--to is for folders and standard output; a file's name tells its format");
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  const Arguments given(argc, argv, visible_options());
  CommandLine command;
  command.help = given.has("help");
  command.version = given.has("version");
  if (command.help || command.version) return command;
  command.report = given.text("report");
  command.dump_steps = given.text("dump-steps");
  command.to = "ply";
  given.with("to", [&](const auto& name, const auto& text) {
    command.to = parse_format(name, text, io::mesh_formats());
  });
  given.with("format", [&](const auto& name, const auto& text) {
    command.from = parse_format(name, text, io::cloud_formats());
  });
  given.with("jobs", [&](const auto& name, const auto& text) { command.jobs = parse_count(name, text, 0); });
  choose_files(given, command);
  command.filters = filter_options(given);
  command.options = reconstruction_options(given);

  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (command.jobs == 0) command.jobs = processors;
  command.jobs = std::min(command.jobs, static_cast<int>(command.tasks.size()));
  if (command.options.threads == 0 && command.jobs > 1)  // more would only get in each other's way
    command.options.threads = std::max(1, processors / command.jobs);
  return command;
}

std::string usage() {
  std::ostringstream text;
  text << "usage: pcd_to_mesh INPUT OUTPUT [options]\n"
          "       pcd_to_mesh INPUT.. FOLDER/ [options]\n"
          "       pcd_to_mesh --out-dir FOLDER INPUT.. [options]\n\n"
          "Turns point clouds without normals into closed manifold triangle meshes through their points; "
          "with\n"
          "--open, into meshes of what was seen, with borders.\n"
          "  INPUT   .pcd .ply .obj .stl .xyz .txt (of a mesh, the vertices), or - for standard input\n"
          "  OUTPUT  .ply (binary) .obj .stl .vtk .glb, or - for standard output; coordinates keep all\n"
          "          digits (.glb has single precision), colours go into all but .stl\n"
          "  FOLDER  takes a mesh for every INPUT, by its name; it is made if need be. An input that fails\n"
          "          does not stop the others.\n\n"
       << visible_options()
       << "\nExit status: 0 with every mesh written, 2 for a wrong command line, 130 if interrupted, else "
          "1.\n";
  return text.str();
}

}  // namespace filmsticking::app
