// SPDX-License-Identifier: GPL-3.0-or-later
// mesh_report: measurements of a mesh.
#include <cstdio>

#include "command_line.h"
#include "common/program.h"
#include "io/formats.h"
#include "io/with_file.h"
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
  if (!command.points.empty()) points = io::positions_of(read_points("mesh_report", command.points).points);
  mesh_report::Surface truth;
  if (!command.truth.empty())
    truth = mesh_report::make_surface(with_file(command.truth, [&] { return io::read_mesh(command.truth); }));

  mesh_report::Report report = mesh_report::report_on(mesh);
  if (!command.points.empty()) report.cloud = mesh_report::cloud_fit(mesh, points);
  if (!command.truth.empty())
    report.truth = mesh_report::truth_fit(mesh, report.topology, truth, command.samples);
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
