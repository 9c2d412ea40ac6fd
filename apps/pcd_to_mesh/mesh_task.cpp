// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_task.h"

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <new>
#include <utility>

#include "common/mesh_model.h"
#include "common/stop_signal.h"
#include "common/summary.h"
#include "filters/model_filter.h"
#include "io/files.h"
#include "io/format.h"
#include "io/model_file.h"
#include "io/with_file.h"
#include "step_dump.h"

namespace fs = std::filesystem;

namespace filmsticking::app {
namespace {

using io::with_file;

std::string shown(const std::string& path, const char* stream) {
  return path == kStandardStream ? stream : path;
}

io::Model read_input(const std::string& path, const CommandLine& command) {
  const std::int64_t most = command.options.max_memory;
  if (path != kStandardStream && command.from.empty()) return io::read_cloud(path, most);
  std::string bytes =
      path == kStandardStream ? io::read_standard_input(most, &stop_asked) : io::read_file(path, most);
  const std::string known = command.from.empty() ? io::detect_format(bytes) : command.from;
  if (known.empty()) throw io::IoError("its format is not recognised; --format names it");
  io::Model cloud = io::decode_cloud(known, std::move(bytes));
  if (cloud.positions.empty()) throw io::IoError("there are no points in it");
  return cloud;
}

/// Refuses an output that could not be written, before the work.
void check_output(const Task& task, const CommandLine& command) {
  if (task.output == kStandardStream) {
    if (isatty(STDOUT_FILENO) && command.to != "obj")
      throw io::IoError("it is a terminal; send it to a file or a program");
    return;
  }
  if (!io::can_write_model(task.output))
    throw io::IoError("its extension is none of .ply .obj .stl .vtk .glb");
  std::error_code error;
  if (fs::equivalent(task.input, task.output, error)) throw io::IoError("it is the input");
  io::check_writable(task.output);
}

void write_output(const Task& task, const CommandLine& command, const io::Model& mesh) {
  if (task.output == kStandardStream) {
    io::encode_model(command.to, mesh, io::write_standard_output);
  } else {
    io::write_model(task.output, mesh);
  }
}

void run(const Task& task, const CommandLine& command, const Progress& progress, TaskResult& outcome) {
  RunFacts& facts = outcome.facts;
  io::Model cloud;
  try {
    cloud = with_file(facts.input, [&] { return read_input(task.input, command); });
  } catch (const io::IoError&) {
    outcome.interrupted = stop_asked;
    throw;
  }
  facts.read = static_cast<std::int64_t>(cloud.positions.size());
  with_file(facts.output, [&] { check_output(task, command); });
  if (command.filters.any()) {
    try {
      cloud = filters::filter(cloud, command.filters);
    } catch (const filters::FilterError& error) {
      throw io::IoError(facts.input + ": " + error.what());
    }
    if (cloud.positions.empty()) throw io::IoError(facts.input + ": the filters leave no point");
  }

  StepDump dump(command.dump_steps);
  Execution execution;
  execution.progress = progress;
  execution.cancel = &stop_asked;
  if (!command.dump_steps.empty())
    execution.on_step = [&dump](int step, const Mesh& film) { dump.write(step, film); };
  Options options = command.options;
  if (!options.viewpoint) options.viewpoint = cloud.viewpoint;
  outcome.result = reconstruct(cloud.positions, options, execution);
  outcome.reached = true;
  if (!dump.error().empty()) throw io::IoError(dump.error());
  outcome.interrupted = outcome.result.status == Status::Cancelled;
  if (outcome.result.status != Status::Ok) throw io::IoError(facts.input + ": " + reason(outcome.result));
  with_file(facts.output, [&] { write_output(task, command, mesh_model(std::move(cloud), outcome.result)); });
}

}  // namespace

TaskResult run_task(const Task& task, const CommandLine& command, const Progress& progress) noexcept {
  const auto begin = std::chrono::steady_clock::now();
  TaskResult outcome;
  outcome.facts.input = shown(task.input, "standard input");
  outcome.facts.output = shown(task.output, "standard output");
  try {
    run(task, command, progress, outcome);
  } catch (const std::bad_alloc&) {
    outcome.error = outcome.facts.input + ": the memory does not suffice";
  } catch (const std::exception& error) {
    outcome.error = error.what();
  }
  outcome.facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  outcome.facts.peak_memory_bytes = peak_memory_bytes();
  return outcome;
}

}  // namespace filmsticking::app
