// SPDX-License-Identifier: GPL-3.0-or-later
// mesh_view: a window with a mesh, its points and the steps to it.
#include <cstdio>
#include <filesystem>

#include "command_line.h"
#include "common/program.h"
#include "contents.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "io/with_file.h"
#include "scene/image.h"
#include "window.h"

using namespace filmsticking;
using namespace filmsticking::app;
using io::with_file;

namespace {

pcl::PolygonMesh read_mesh(const std::string& path) {
  return with_file(path, [&] { return io::read_mesh(path); });
}

void run(const CommandLine& command) {
  std::vector<scene::Step> films;
  if (!command.steps.empty()) films = scene::read_steps(command.steps);
  if (!command.mesh.empty())
    films.push_back({std::filesystem::path(command.mesh).filename().string(), read_mesh(command.mesh)});
  pcl::PCLPointCloud2 cloud;
  if (!command.points.empty()) cloud = read_points("mesh_view", command.points).points;
  std::optional<pcl::PolygonMesh> reference;
  if (!command.reference.empty()) reference = read_mesh(command.reference);

  Contents contents(std::move(films), std::move(cloud), std::move(reference), command.range);
  const scene::DisplayConnection display;
  show_window(contents, command.window);
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("mesh_view", [&] {
    const CommandLine command = parse_command_line(argc, argv);
    if (command.help) {
      std::fputs(usage().c_str(), stdout);
    } else {
      run(command);
    }
    return 0;
  });
}
