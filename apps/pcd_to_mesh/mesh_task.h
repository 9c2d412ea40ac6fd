// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.h"
#include "filmsticking/reconstruct.h"
#include "report_json.h"

namespace filmsticking::app {

/// Receives the share done and the stage at work, from the thread that runs the task.
using Progress = std::function<void(double share, const char* stage)>;

/// The outcome of a task.
struct TaskResult {
  RunFacts facts;
  Result result;             ///< filled when the reconstruction was reached
  std::string error;         ///< a clause that names the file; empty if the mesh was written
  bool reached = false;      ///< whether there is a result
  bool interrupted = false;  ///< by a signal

  bool ok() const { return error.empty(); }
};

/// Reads a cloud, filters it, reconstructs and writes the mesh. Throws nothing: failures are in the result.
TaskResult run_task(const Task& task, const CommandLine& command, const Progress& progress) noexcept;

}  // namespace filmsticking::app
