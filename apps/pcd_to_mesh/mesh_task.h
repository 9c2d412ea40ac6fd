// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.h"
#include "filmsticking/reconstruct.h"
#include "report_json.h"

namespace filmsticking::app {

/// Who hears how far a task is; from the thread that runs it.
using Progress = std::function<void(double share, const char* room)>;

/// What became of a task.
struct TaskResult {
  RunFacts facts;
  Result result;             ///< filled when the reconstruction was reached
  std::string error;         ///< a clause that names the file; empty if the mesh was written
  bool reached = false;      ///< whether there is a result
  bool interrupted = false;  ///< by a signal

  bool ok() const { return error.empty(); }
};

/// Reads a cloud, filters it, reconstructs and writes the mesh. Files that cannot be read or written and the
/// like are in the result; nothing is thrown.
TaskResult run_task(const Task& task, const CommandLine& command, const Progress& progress) noexcept;

}  // namespace filmsticking::app
