// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh_task.h"

namespace filmsticking::app {

/// Runs all tasks, `command.jobs` at a time, with one progress bar; those that fail are named on stderr at
/// once. After a signal no further task begins. The results are in the order of the tasks; those that were
/// not begun have the error "interrupted".
std::vector<TaskResult> run_all(const CommandLine& command);

/// One line a task and a last one for all.
std::string batch_table(const std::vector<TaskResult>& results, double seconds);

}  // namespace filmsticking::app
