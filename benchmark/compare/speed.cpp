// SPDX-License-Identifier: GPL-3.0-or-later
#include "speed.h"

#include <cstdio>
#include <filesystem>

#include "cloud_list.h"
#include "markdown.h"
#include "measure.h"
#include "method_choice.h"
#include "results.h"
#include "scratch_folder.h"
#include "speed_table.h"

namespace filmsticking::bench {
namespace {

bool is_ours(const std::string& method) { return method.rfind("ours", 0) == 0; }

/// What is timed: the methods, and those of ours on one thread too.
std::vector<Series> make_series(const std::vector<std::string>& methods, int threads) {
  std::vector<Series> series;
  for (const std::string& method : methods) {
    series.push_back({method, threads});
    if (is_ours(method) && threads != 1) series.push_back({method, 1});
  }
  return series;
}

}  // namespace

void compare_speed(const CommandLine& command) {
  const std::map<std::string, MethodEntry> entries = find_methods();
  const std::vector<std::string> usual = {"ours", "delaunay", "cgal-advancing-front"};
  const std::vector<Series> series = make_series(
      choose_methods(command.methods.empty() ? usual : command.methods, entries), command.threads);
  const std::vector<CloudPlan> plans = list_clouds(command);
  Results results(command.csv, command.fresh);
  const ScratchFolder scratch;
  std::vector<Row> rows;
  for (const CloudPlan& plan : plans) {
    const std::string folder = scratch / "cloud";
    const CloudFiles files = prepare_cloud(plan.input, plan.spec, true, folder);
    for (int run = 1; run <= command.runs; ++run)
      for (const Series& one : series) {
        Measurement measurement;
        measurement.limits = command.limits;
        measurement.threads = one.threads;
        measurement.run = run;
        measurement.judge = false;
        const Row planned = planned_row(files.row, one.method, measurement);
        if (const Row* done = results.find(planned)) {
          rows.push_back(*done);
          continue;
        }
        const Row row = measure(files, one.method, entries.at(one.method), folder + "/mesh.ply", measurement);
        results.add(row);
        rows.push_back(row);
        std::fprintf(stderr, "%s, %s points, run %d: %s, %s threads: %s, %s s\n", row.text("shape").c_str(),
                     row.text("points").c_str(), run, one.method.c_str(), row.text("threads").c_str(),
                     row.text("status").c_str(), rounded(row.number("seconds"), 3).c_str());
      }
    std::filesystem::remove_all(folder);
  }
  publish(speed_tables(rows, series, command.peer), command.markdown);
}

}  // namespace filmsticking::bench
