// SPDX-License-Identifier: GPL-3.0-or-later
// mesh_report: measurements of a mesh.
#include <cstdio>
#include <filesystem>

#include "command_line.h"
#include "common/program.h"
#include "filters/filter_error.h"
#include "io/files.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "io/with_file.h"
#include "page/page.h"
#include "report/report.h"

using namespace filmsticking;
using namespace filmsticking::app;
using io::with_file;

namespace {

/// The plane that is given, or that is found among the points or else the mesh's vertices.
mesh_report::GroundFit ground_fit(const mesh_report::Surface& mesh, const mesh_report::Topology& topology,
                                  const CommandLine& command, std::vector<Point> points) {
  if (points.empty())
    for (const mesh_report::Vec3& p : mesh.positions) points.push_back({p.x(), p.y(), p.z()});
  try {
    const filters::GroundPlane plane =
        command.ground.plane ? *command.ground.plane : filters::find_ground(points);
    return mesh_report::ground_fit(mesh, topology, plane.up, plane.offset);
  } catch (const filters::FilterError& error) {
    throw io::IoError((command.points.empty() ? command.mesh : command.points) + ": " + error.what());
  }
}

void run(const CommandLine& command) {
  // All files are read before the work, so that a broken one fails at once.
  const mesh_report::Surface mesh =
      mesh_report::make_surface(with_file(command.mesh, [&] { return io::read_model(command.mesh); }));
  std::vector<Point> points;
  if (!command.points.empty()) points = io::positions_of(read_points("mesh_report", command.points).points);
  mesh_report::Surface truth;
  if (!command.truth.empty())
    truth = mesh_report::make_surface(with_file(command.truth, [&] { return io::read_mesh(command.truth); }));

  if (!command.html.empty()) with_file(command.html, [&] { io::check_writable(command.html); });

  mesh_report::Report report = mesh_report::report_on(mesh);
  report.unit = command.unit;
  if (command.ground.asked) report.ground = ground_fit(mesh, report.topology, command, points);
  mesh_report::CloudDistances distances;
  if (!command.points.empty()) {
    distances = cloud_distances(mesh, points);
    report.cloud = mesh_report::cloud_fit_of(mesh, distances);
  }
  if (!command.truth.empty())
    report.truth = mesh_report::truth_fit(mesh, report.topology, truth, command.samples);
  if (!command.html.empty())
    with_file(command.html, [&] {
      page::write_page(command.html, {std::filesystem::path(command.mesh).filename().string(), mesh, report,
                                      command.points.empty() ? nullptr : &distances,
                                      command.truth.empty() ? nullptr : &truth});
    });
  std::fputs((command.json ? to_json(report) : to_text(report)).c_str(), stdout);
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("mesh_report", [&] {
    const CommandLine command = parse_command_line(argc, argv);
    if (command.help) {
      std::fputs(usage().c_str(), stdout);
    } else {
      run(command);
    }
    return 0;
  });
}
