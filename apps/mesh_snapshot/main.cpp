// SPDX-License-Identifier: GPL-3.0-or-later
// mesh_snapshot: a picture of one or more meshes.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>

#include "command_line.h"
#include "io/files.h"
#include "io/io_error.h"
#include "io/model_file.h"
#include "io/with_file.h"
#include "scene.h"

using namespace filmsticking;
using namespace filmsticking::app;
using io::with_file;

namespace {

void run(const CommandLine& command) {
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display) throw io::IoError("there is no X display; xvfb-run -a brings one");

  with_file(command.output, [&] { io::check_writable(command.output); });
  std::vector<Panel> panels;
  for (const std::string& path : command.meshes) {
    Panel panel;
    if (path != kNoMesh) panel.mesh = with_file(path, [&] { return io::read_mesh(path); });
    if (command.labels) panel.label = std::filesystem::path(path).filename().string();
    if (!command.captions.empty()) panel.label = command.captions[panels.size()];
    panels.push_back(std::move(panel));
  }
  std::vector<Point> points;
  if (!command.points.empty())
    points = with_file(command.points, [&] { return io::read_cloud(command.points).positions; });

  const std::string png = render_png(panels, points, command.view);
  with_file(command.output, [&] { io::write_file(command.output, png); });
  std::printf("wrote %s (%d x %d)\n", command.output.c_str(), command.view.width, command.view.height);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const CommandLine command = parse_command_line(argc, argv);
    if (command.help) {
      std::fputs(usage().c_str(), stdout);
    } else {
      run(command);
    }
    return 0;
  } catch (const UsageError& error) {
    std::fprintf(stderr, "mesh_snapshot: %s.\n", error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    std::fputs("mesh_snapshot: the memory does not suffice.\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mesh_snapshot: %s.\n", error.what());
  }
  return 1;
}
