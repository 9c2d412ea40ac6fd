// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh_task.h"

namespace filmsticking::app {

/// Runs all tasks, `command.jobs` at a time, with one progress bar; a failure is printed on stderr at
/// once. After a signal no further task begins. Results have the order of the tasks; a task that did not
/// begin has the error "interrupted".
std::vector<TaskResult> run_all(const CommandLine& command);

/// One line a task, and a summary line.
std::string batch_table(const std::vector<TaskResult>& results, double seconds);

}  // namespace filmsticking::app
