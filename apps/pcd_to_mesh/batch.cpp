// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch.h"

#include <algorithm>
#include <atomic>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <numeric>
#include <thread>

#include "common/program.h"
#include "common/progress_bar.h"
#include "common/stop_signal.h"
#include "common/summary.h"

namespace filmsticking::app {
namespace {

/// One bar for concurrent tasks.
class SharedBar {
 public:
  explicit SharedBar(std::size_t tasks) : shares_(tasks, 0) {}

  void show(std::size_t task, double share, const std::string& at_work) {
    const std::lock_guard<std::mutex> lock(mutex_);
    shares_[task] = share;
    bar_.show(std::accumulate(shares_.begin(), shares_.end(), 0.0) / static_cast<double>(shares_.size()),
              at_work);
  }

  void complain(const std::string& what) {
    const std::lock_guard<std::mutex> lock(mutex_);
    bar_.hide();
    app::complain("pcd_to_mesh", what);
  }

 private:
  std::mutex mutex_;
  ProgressBar bar_;
  std::vector<double> shares_;
};

std::string name_of(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace

std::vector<TaskResult> run_all(const CommandLine& command) {
  const std::size_t count = command.tasks.size();
  std::vector<TaskResult> results(count);
  for (std::size_t i = 0; i < count; ++i) {
    results[i].facts.input = command.tasks[i].input;
    results[i].facts.output = command.tasks[i].output;
    results[i].error = "interrupted";
  }
  SharedBar bar(count);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < count && !stop_asked; i = next++) {
      const std::string name = name_of(command.tasks[i].input);
      results[i] = run_task(command.tasks[i], command, [&](double share, const char* stage) {
        bar.show(i, share, name + ": " + stage);
      });
      bar.show(i, 1, name);
      for (const std::string& note : results[i].facts.notes) bar.complain(note);
      if (!results[i].ok() && !results[i].interrupted) bar.complain(results[i].error);
    }
  };
  std::vector<std::thread> workers;
  for (int k = 1; k < command.jobs; ++k) workers.emplace_back(work);
  work();
  for (std::thread& worker : workers) worker.join();
  return results;
}

std::string batch_table(const std::vector<TaskResult>& results, double seconds) {
  std::size_t width = 5;
  for (const TaskResult& r : results) width = std::max(width, name_of(r.facts.input).size());
  const auto padded = [width](const std::string& name) {
    return name + std::string(width - std::min(width, name.size()), ' ');
  };
  std::string table = padded("input") + "     points   vertices  triangles  closed  genus  pieces  seconds\n";
  std::size_t written = 0;
  for (const TaskResult& r : results) {
    table += padded(name_of(r.facts.input));
    if (!r.ok()) {
      table += std::string("  failed") + (r.reached ? std::string(": ") + status_name(r.result.status) : "");
      table += '\n';
      continue;
    }
    ++written;
    const Report& report = r.result.report;
    char line[200];
    std::snprintf(line, sizeof line, " %10" PRId64 " %10zu %10zu  %-6s %6" PRId64 " %7" PRId64 " %8.1f\n",
                  report.points, r.result.vertices.size(), r.result.triangles.size(),
                  report.closed ? "yes" : "no", report.genus, report.components, r.facts.seconds);
    table += line;
  }
  table += std::to_string(written) + " of " + std::to_string(results.size()) + " meshes written in " +
           cost_summary(seconds) + "\n";
  return table;
}

}  // namespace filmsticking::app
