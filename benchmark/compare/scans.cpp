// SPDX-License-Identifier: GPL-3.0-or-later
#include "scans.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "clouds/scan_kinds.h"
#include "io/files.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "markdown.h"
#include "measure.h"
#include "method_choice.h"
#include "scan_result.h"
#include "scan_table.h"
#include "scratch_folder.h"

namespace filmsticking::bench {
namespace {

/// In the order in which they are asked for; all without names.
std::vector<ScanKind> chosen_kinds(const std::vector<std::string>& names) {
  const std::vector<ScanKind> all = scan_kinds();
  if (names.empty()) return all;
  std::vector<ScanKind> chosen;
  for (const std::string& name : names)
    std::copy_if(all.begin(), all.end(), std::back_inserter(chosen),
                 [&](const ScanKind& kind) { return name == kind.name; });
  return chosen;
}

/// A scan on the disk, ready for the methods.
CloudFiles write_scan(const Scan& scan, const std::string& kind, std::uint64_t seed,
                      const std::string& folder) {
  CloudFiles files{folder + "/cloud.ply", "", Row()};
  files.row.set("shape", kind);
  files.row.set("kind", "scan");
  files.row.set("points", std::to_string(scan.points.size()));
  files.row.set("seed", std::to_string(seed));
  std::filesystem::create_directories(folder);
  files.direction = scan.direction;
  pcl::PCLPointCloud2 cloud = io::make_cloud(scan.points);
  if (!scan.sensors.empty()) cloud = io::with_named_stations(io::with_stations(cloud, scan.sensors));
  io::write_mesh(files.cloud, cloud, {});
  return files;
}

ScanResult run_scan(const Scan& scan, const CloudFiles& files, const std::string& method,
                    const MethodEntry& entry, const std::string& mesh_path, const Measurement& measurement) {
  ScanResult result;
  result.kind = files.row.text("shape");
  result.method = method;
  result.points = scan.points.size();
  std::filesystem::remove(mesh_path);  // of an earlier run with --keep
  result.row = measure(files, method, entry, mesh_path, measurement);
  if (!result.row.ended_well()) {
    judge_scan(result, scan, nullptr);
    return result;
  }
  const pcl::PolygonMesh model = io::read_model(mesh_path);
  const ScanMeasures measures =
      measure_scan({io::positions_of(model.cloud), io::triangles_of(model.polygons)}, scan);
  judge_scan(result, scan, &measures);
  return result;
}

void print(const ScanResult& result) {
  std::fprintf(stderr, "%s, seed %llu, %zu points: %s: %s; %s s\n", result.kind.c_str(),
               static_cast<unsigned long long>(result.seed), result.points, result.method.c_str(),
               result.wrong.empty() ? "right" : result.wrong.c_str(),
               rounded(result.row.number("seconds"), 3).c_str());
}

/// The CSV, which grows run by run.
class ScanCsv {
 public:
  explicit ScanCsv(const std::string& path) : path_(path) {
    if (path_.empty()) return;
    try {
      io::write_file(path_, scan_csv_header());
    } catch (const io::IoError& error) {
      throw std::runtime_error(path_ + ": " + error.what());
    }
  }

  void add(const ScanResult& result) const {
    if (path_.empty()) return;
    std::ofstream file(path_, std::ios::app | std::ios::binary);
    file << scan_csv_line(result) << std::flush;
    if (!file) throw std::runtime_error(path_ + ": it cannot be written");
  }

 private:
  std::string path_;
};

}  // namespace

void compare_scans(const CommandLine& command) {
  const std::map<std::string, MethodEntry> entries = find_methods();
  if (!command.methods.empty()) choose_methods(command.methods, entries);  // refuses unknown ones
  Measurement measurement;
  measurement.limits = command.limits;
  measurement.threads = command.threads;

  const ScanCsv csv(command.csv);
  const ScratchFolder scratch;
  std::vector<ScanResult> results;
  for (const ScanKind& of : chosen_kinds(command.kinds)) {
    const std::string kind = of.name;
    const std::vector<std::string> methods =
        command.methods.empty() ? split_list(of.methods) : command.methods;
    for (const std::uint64_t seed : command.seeds) {
      const Scan scan = make_scan(kind, seed);
      const std::string folder =
          (command.keep.empty() ? scratch / "scans" : command.keep) + "/" + kind + "_" + std::to_string(seed);
      const CloudFiles files = write_scan(scan, kind, seed, folder);
      for (const std::string& method : methods) {
        ScanResult result =
            run_scan(scan, files, method, entries.at(method), folder + "/" + method + ".ply", measurement);
        result.seed = seed;
        print(result);
        csv.add(result);
        results.push_back(std::move(result));
      }
      if (command.keep.empty()) std::filesystem::remove_all(folder);
    }
  }
  publish(scan_tables(results), command.markdown);
}

}  // namespace filmsticking::bench
