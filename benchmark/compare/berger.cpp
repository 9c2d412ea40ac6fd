// SPDX-License-Identifier: GPL-3.0-or-later
#include "berger.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "csv.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "markdown.h"
#include "measure.h"
#include "method_choice.h"
#include "occupancy.h"
#include "scratch_folder.h"

namespace fs = std::filesystem;

namespace filmsticking::bench {
namespace {

constexpr const char* kMethods =
    "ours-sight,ours,cgal-advancing-front,cgal-alpha-wrap,cgal-scale-space,pcl-gp3,pcl-poisson,"
    "pcl-poisson-sight";

std::vector<std::string> names_in(const std::string& folder) {
  constexpr const char* kProbes = ".occupancy.f32";
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string file = entry.path().filename().string();
    const std::size_t at = file.find(kProbes);
    if (at != std::string::npos && at + std::string(kProbes).size() == file.size())
      names.push_back(file.substr(0, at));
  }
  if (error) throw std::runtime_error(folder + ": " + error.message());
  if (names.empty()) throw std::runtime_error(folder + ": there is no NAME.occupancy.f32 in it");
  std::sort(names.begin(), names.end());
  return names;
}

struct Run {
  Row row;
  std::optional<Overlap> overlap;
};

Run run(const CloudFiles& files, const std::vector<Probe>& probes, const std::string& method,
        const MethodEntry& entry, const std::string& mesh, const Measurement& measurement) {
  fs::remove(mesh);  // of an earlier run with --keep
  Run done{measure(files, method, entry, mesh, measurement), std::nullopt};
  if (!done.row.ended_well()) return done;
  const pcl::PolygonMesh model = io::read_model(mesh);
  done.overlap = overlap({io::positions_of(model.cloud), io::triangles_of(model.polygons)}, probes);
  return done;
}

std::string csv_of(const std::vector<Run>& runs) {
  const std::vector<std::string> of_row = {"shape",        "points",         "method",
                                           "status",       "message",        "components",
                                           "genus",        "boundary_edges", "non_manifold_edges",
                                           "interpolated", "seconds",        "cpu_seconds"};
  std::vector<std::string> header = of_row;
  header.insert(header.end(), {"iou", "missing", "extra"});
  std::string csv = csv_line(header);
  for (const Run& run : runs) {
    std::vector<std::string> fields;
    for (const std::string& column : of_row) fields.push_back(run.row.text(column));
    for (const auto member : {&Overlap::iou, &Overlap::missing, &Overlap::extra})
      fields.push_back(run.overlap ? to_text((*run.overlap).*member) : "");
    csv += csv_line(fields);
  }
  return csv;
}

std::string table_of(const std::vector<Run>& runs) {
  std::vector<std::vector<std::string>> rows = {{"model", "method", "IoU", "missing", "extra", "components",
                                                 "boundary edges", "non-manifold edges", "seconds",
                                                 "CPU seconds"}};
  for (const Run& run : runs) {
    const auto shown = [&](const char* column) {
      const std::string& text = run.row.text(column);
      return text.empty() ? "-" : text;
    };
    const auto of = [&](double Overlap::*member) {
      return run.overlap ? rounded((*run.overlap).*member, 3) : "-";
    };
    rows.push_back(
        {run.row.text("shape"), run.row.text("method"),
         run.row.ended_well() ? run.overlap ? of(&Overlap::iou) : "no inside" : run.row.text("status"),
         of(&Overlap::missing), of(&Overlap::extra), shown("components"), shown("boundary_edges"),
         shown("non_manifold_edges"), rounded(run.row.number("seconds"), 3),
         rounded(run.row.number("cpu_seconds"), 3)});
  }
  return markdown_table(rows);
}

}  // namespace

void compare_berger(const CommandLine& command) {
  const std::map<std::string, MethodEntry> entries = find_methods();
  const std::vector<std::string> methods =
      choose_methods(command.methods.empty() ? split_list(kMethods) : command.methods, entries);
  Measurement measurement;
  measurement.limits = command.limits;
  measurement.threads = command.threads;
  const ScratchFolder scratch;
  std::vector<Run> runs;
  for (const std::string& name : names_in(command.inputs.front())) {
    const std::string base = command.inputs.front() + "/" + name;
    const std::vector<Probe> probes = read_probes(base + ".occupancy.f32");
    CloudFiles files{base + ".ply", "", Row()};
    files.row.set("shape", name);
    try {
      files.row.set("points", std::to_string(io::size_of(io::read_cloud(files.cloud).points)));
    } catch (const io::IoError& error) {
      throw std::runtime_error(files.cloud + ": " + error.what());
    }
    const std::string folder = (command.keep.empty() ? scratch / "berger" : command.keep) + "/" + name;
    fs::create_directories(folder);
    for (const std::string& method : methods) {
      runs.push_back(
          run(files, probes, method, entries.at(method), folder + "/" + method + ".ply", measurement));
      std::fprintf(stderr, "%s: %s: %s\n", name.c_str(), method.c_str(),
                   runs.back().overlap ? ("IoU " + rounded(runs.back().overlap->iou, 4)).c_str()
                                       : runs.back().row.text("status").c_str());
    }
  }
  if (!command.csv.empty()) publish(csv_of(runs), command.csv);
  publish(table_of(runs), command.markdown);
}

}  // namespace filmsticking::bench
