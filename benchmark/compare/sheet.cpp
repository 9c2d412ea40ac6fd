// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "cloud_list.h"
#include "measure.h"
#include "method_choice.h"
#include "scratch_folder.h"

namespace filmsticking::bench {
namespace {

constexpr int kPanelPixels = 420;
constexpr int kMostPixels = 16384;  // a side, of mesh_snapshot

/// The file of a panel, "-" for an empty one, and its caption.
struct Panel {
  std::string mesh, label;
};

/// One row of the sheet.
std::vector<Panel> make_row(const CloudPlan& plan, const std::vector<std::string>& methods,
                            const std::map<std::string, MethodEntry>& entries, const Measurement& measurement,
                            const std::string& folder) {
  const CloudFiles files = prepare_cloud(plan.input, plan.spec, true, folder);
  std::vector<Panel> panels = {{files.truth.empty() ? "-" : files.truth,
                                plan.input.name + (files.truth.empty() ? ": not known" : ": ground truth")}};
  for (const std::string& method : methods) {
    const std::string mesh = folder + "/" + method + ".ply";
    const Row row = measure(files, method, entries.at(method), mesh, measurement);
    const bool there = row.ended_well();
    panels.push_back({there ? mesh : "-", method + (there ? "" : ": " + row.text("status"))});
    std::fprintf(stderr, "%s: %s: %s\n", plan.input.name.c_str(), method.c_str(), row.text("status").c_str());
  }
  return panels;
}

}  // namespace

void draw_sheet(const CommandLine& command) {
  const std::map<std::string, MethodEntry> entries = find_methods();
  std::vector<std::string> methods = choose_methods(command.methods, entries);
  for (const std::string& method : methods)
    if (!entries.at(method).makes_mesh) throw UsageError(method + " makes no mesh to draw");
  const ScratchFolder scratch;
  Measurement measurement;
  measurement.limits = command.limits;
  measurement.threads = command.threads;
  measurement.judge = false;

  const std::string folder = command.keep.empty() ? scratch / "clouds" : command.keep;
  std::vector<Panel> panels;
  std::size_t rows = 0;
  for (const CloudPlan& plan : list_clouds(command)) {
    const std::vector<Panel> row =
        make_row(plan, methods, entries, measurement, folder + "/" + std::to_string(++rows));
    panels.insert(panels.end(), row.begin(), row.end());
  }

  const std::size_t columns = methods.size() + 1;
  const auto pixels = [](std::size_t n) {
    return std::to_string(std::min<std::size_t>(kPanelPixels * n, kMostPixels));
  };
  std::vector<std::string> drawing;
  if (const char* display = std::getenv("DISPLAY"); !display || !*display) {
    // An own file for the display's key: xvfb-run fails where it cannot remove its own.
    std::ofstream(scratch / "key").flush();
    drawing = {"xvfb-run", "-a", "-f", scratch / "key"};
  }
  drawing.insert(drawing.end(), {sibling_program("mesh_snapshot"), "-o", command.output, "--columns",
                                 std::to_string(columns), "--fit", "row", "--grey-backs", "--size",
                                 pixels(columns) + "x" + pixels(rows)});
  if (!command.view.empty()) drawing.insert(drawing.end(), {"--view", command.view});
  if (!command.up.empty()) drawing.insert(drawing.end(), {"--up", command.up});
  for (const Panel& panel : panels) drawing.insert(drawing.end(), {"--label", panel.label});
  for (const Panel& panel : panels) drawing.push_back(panel.mesh);
  const ChildEnd end = run_child(drawing, {});
  if (end.code != 0) throw std::runtime_error("the sheet was not drawn: " + end.err);
  std::fputs(end.out.c_str(), stdout);
}

}  // namespace filmsticking::bench
