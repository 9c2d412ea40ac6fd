// SPDX-License-Identifier: GPL-3.0-or-later
// pcd_to_mesh: files of points in, files with closed manifold meshes out.
#include <pcl/console/print.h>

#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <filesystem>

#include "batch.h"
#include "command_line.h"
#include "common/filter_arguments.h"
#include "common/program.h"
#include "common/progress_bar.h"
#include "common/stop_signal.h"
#include "common/summary.h"
#include "io/files.h"
#include "io/with_file.h"
#include "mesh_task.h"
#include "report_json.h"

namespace fs = std::filesystem;
using namespace filmsticking;
using namespace filmsticking::app;
using io::with_file;

namespace {

constexpr const char* kName = "pcd_to_mesh";

/// Makes the folders, and refuses a report that cannot be written, before the work.
void prepare_outputs(const CommandLine& command) {
  if (command.batch)
    with_file(command.folder, [&] {
      fs::create_directories(command.folder);
      if (!fs::is_directory(command.folder)) throw io::IoError("it is not a folder");
    });
  if (!command.report.empty()) with_file(command.report, [&] { io::check_writable(command.report); });
  if (!command.html.empty()) with_file(command.html, [&] { io::check_writable(command.html); });
  if (!command.dump_steps.empty())
    with_file(command.dump_steps, [&] { fs::create_directories(command.dump_steps); });
}

void write_report(const CommandLine& command, const std::string& json) {
  if (!command.report.empty()) with_file(command.report, [&] { io::write_file(command.report, json); });
}

/// The stream for the summary: the mesh may go to standard output.
std::FILE* stream_for_people(const CommandLine& command) {
  return command.tasks[0].output == kStandardStream ? stderr : stdout;
}

void print_summary(const CommandLine& command, const TaskResult& outcome) {
  const Report& report = outcome.result.report;
  const RunFacts& facts = outcome.facts;
  std::FILE* stream = stream_for_people(command);
  std::fprintf(stream, "cloud   %s: %" PRId64 " points", facts.input.c_str(), facts.read);
  if (command.filters.any())
    std::fprintf(stream, ", %" PRId64 " after %s", report.points, names_of(command.filters).c_str());
  if (report.non_finite > 0) std::fprintf(stream, ", %" PRId64 " not finite", report.non_finite);
  if (report.duplicates > 0) std::fprintf(stream, ", %" PRId64 " repeated", report.duplicates);
  if (facts.ground)
    std::fprintf(stream, "\nground  %s: %" PRId64 " points left out, %" PRId64 " added",
                 filters::to_text(*facts.ground).c_str(), facts.on_ground, facts.added);
  std::fprintf(stream, "\n%stook    %s\n", mesh_summary(outcome.result.report, facts.output).c_str(),
               cost_summary(facts.seconds).c_str());
}

int run_one(const CommandLine& command) {
  TaskResult outcome;
  {
    ProgressBar bar;
    outcome = run_task(command.tasks[0], command,
                       [&bar](double share, const char* stage) { bar.show(share, stage); });
  }
  for (const std::string& note : outcome.facts.notes) complain(kName, note);
  if (outcome.reached) write_report(command, report_json(outcome.result, outcome.facts));
  if (outcome.ok()) {
    print_summary(command, outcome);
    return 0;
  }
  complain(kName, outcome.error);
  return outcome.interrupted ? kInterrupted : kFailed;
}

int run_batch(const CommandLine& command) {
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<TaskResult> results = run_all(command);
  std::string list;
  for (const TaskResult& r : results)
    if (r.reached) list += (list.empty() ? "" : ",\n") + report_json(r.result, r.facts);
  write_report(command, "[\n" + list + "]\n");
  std::fputs(
      batch_table(results, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count())
          .c_str(),
      stdout);
  if (stop_asked) {
    complain(kName, "interrupted");
    return kInterrupted;
  }
  return std::all_of(results.begin(), results.end(), [](const TaskResult& r) { return r.ok(); }) ? 0
                                                                                                 : kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program(kName, [&] {
    const CommandLine command = parse_command_line(argc, argv);
    if (command.help) std::fputs(usage().c_str(), stdout);
    if (command.version) std::puts("pcd_to_mesh " FILMSTICKING_VERSION);
    if (command.help || command.version) return 0;
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);  // errors are said once, by this program
    stop_on_signal();
    prepare_outputs(command);
    return command.batch ? run_batch(command) : run_one(command);
  });
}
