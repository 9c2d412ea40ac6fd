// SPDX-License-Identifier: GPL-3.0-or-later
// mesh_report: measurements of a mesh.
#include <cstdio>
#include <filesystem>

#include "command_line.h"
#include "common/program.h"
#include "io/files.h"
#include "io/formats.h"
#include "io/with_file.h"
#include "page/page.h"
#include "report/report.h"

using namespace filmsticking;
using namespace filmsticking::app;
using io::with_file;

namespace {

void run(const CommandLine& command) {
  // All files are read before the work, so that a broken one fails at once.
  const mesh_report::Surface mesh =
      mesh_report::make_surface(with_file(command.mesh, [&] { return io::read_model(command.mesh); }));
  std::vector<Point> points;
  if (!command.points.empty())
    points =
        io::positions_of(with_file(command.points, [&] { return io::read_cloud(command.points); }).points);
  mesh_report::Surface truth;
  if (!command.truth.empty())
    truth = mesh_report::make_surface(with_file(command.truth, [&] { return io::read_mesh(command.truth); }));

  if (!command.html.empty()) with_file(command.html, [&] { io::check_writable(command.html); });

  mesh_report::Report report = mesh_report::report_on(mesh);
  mesh_report::CloudDistances distances;
  if (!command.points.empty()) {
    distances = cloud_distances(mesh, points);
    report.cloud = mesh_report::cloud_fit(mesh, distances);
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
