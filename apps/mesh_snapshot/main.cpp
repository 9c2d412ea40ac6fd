// SPDX-License-Identifier: GPL-3.0-or-later
// mesh_snapshot: a picture or an animation of one or more meshes.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "command_line.h"
#include "common/program.h"
#include "io/files.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "io/with_file.h"
#include "report/scale_length.h"
#include "scene/deviation.h"
#include "scene/image.h"
#include "scene/steps.h"
#include "sheet.h"

namespace fs = std::filesystem;
using namespace filmsticking;
using namespace filmsticking::app;
using io::with_file;

namespace {

/// Of all pictures of a GIF, which are in memory together.
constexpr double kMostPixelsOfAll = 100e6;

/// Reads the meshes.
std::vector<Panel> read_panels(const CommandLine& command) {
  std::vector<Panel> panels;
  const auto add = [&](const std::string& path, std::vector<Film> films) {
    Panel panel;
    panel.films = std::move(films);
    if (command.labels) panel.label = fs::path(path).filename().string();
    if (!command.captions.empty()) panel.label = command.captions[panels.size()];
    panels.push_back(std::move(panel));
  };
  if (!command.steps.empty()) {
    std::vector<Film> films;
    for (scene::Step& step : scene::read_steps(command.steps))
      films.push_back({std::move(step.film), {}, {}});
    add(command.steps, std::move(films));
  }
  for (const std::string& path : command.meshes) {
    Film film;
    if (path != kNoMesh) film.mesh = with_file(path, [&] { return io::read_mesh(path); });
    add(path, {std::move(film)});
  }
  return panels;
}

/// Measures the distances to show, and chooses the end of their colour scale.
void measure(const CommandLine& command, const pcl::PCLPointCloud2& cloud, std::vector<Panel>& panels,
             double& scale) {
  std::vector<double> all;
  const auto keep = [&all](const scene::Values& values) {
    all.insert(all.end(), values.begin(), values.end());
  };
  std::optional<scene::Deviation> reference;
  if (!command.reference.empty())
    with_file(command.reference, [&] { reference.emplace(io::read_mesh(command.reference)); });
  for (Panel& panel : panels)
    for (Film& film : panel.films) {
      if (film.mesh.polygons.empty()) continue;
      if (reference) keep(film.face_values = reference->of_faces(film.mesh));
      if (command.deviation)
        keep(film.point_values = scene::Deviation(film.mesh).of_points(io::positions_of(cloud)));
    }
  scale = command.range > 0 ? command.range : mesh_report::scale_length(std::move(all));
}

/// "out.png" to "out_007.png".
std::string numbered(const std::string& path, int number) {
  char ending[16];
  std::snprintf(ending, sizeof ending, "_%03d.png", number);
  return fs::path(path).replace_extension().string() + ending;
}

void run(CommandLine command) {
  with_file(command.output, [&] { io::check_writable(command.output); });
  std::vector<Panel> panels = read_panels(command);
  pcl::PCLPointCloud2 cloud;
  if (!command.points.empty()) cloud = read_points("mesh_snapshot", command.points).points;
  measure(command, cloud, panels, command.view.style.scale);

  std::size_t pictures = static_cast<std::size_t>(command.turns);
  if (command.turns == 1)
    for (const Panel& panel : panels) pictures = std::max(pictures, panel.films.size());
  const View& view = command.view;
  const bool animation = io::extension_of(command.output) == ".gif";
  if (animation && static_cast<double>(pictures) * view.width * view.height > kMostPixelsOfAll)
    throw io::IoError("the animation is too large; take fewer pictures or a smaller --size");

  const scene::DisplayConnection display;
  std::vector<vtkSmartPointer<vtkImageData>> film;
  int number = 0;
  draw_sheet(panels, cloud, view, command.turns, [&](const vtkSmartPointer<vtkImageData>& picture) {
    if (animation) {
      film.push_back(picture);
      return;
    }
    const std::string path = pictures > 1 ? numbered(command.output, number++) : command.output;
    with_file(path, [&] { io::write_file(path, scene::encode_png(picture)); });
  });
  if (animation)
    with_file(command.output,
              [&] { io::write_file(command.output, scene::encode_gif(film, command.pictures_per_second)); });
  const std::string written = animation || pictures == 1 ? command.output
                                                         : numbered(command.output, 0) + " to " +
                                                               numbered(command.output, number - 1);
  std::printf("wrote %s (%d x %d", written.c_str(), view.width, view.height);
  if (pictures > 1) std::printf(", %zu pictures", pictures);
  std::puts(")");
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("mesh_snapshot", [&] {
    const CommandLine command = parse_command_line(argc, argv);
    if (command.help) {
      std::fputs(usage().c_str(), stdout);
    } else {
      run(command);
    }
    return 0;
  });
}
