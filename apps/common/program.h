// SPDX-License-Identifier: GPL-3.0-or-later
// What every program's main() has in common.
#pragma once

#include <functional>
#include <string>

#include "io/cloud.h"

namespace filmsticking::app {

/// Exit statuses; 0 is success.
constexpr int kFailed = 1, kWrongUsage = 2, kInterrupted = 130;

/// Runs `body` and returns its result, the exit status. An exception becomes a line on stderr that begins
/// with the name of the program; the status is kWrongUsage for UsageError, else kFailed.
int run_program(const char* program, const std::function<int()>& body) noexcept;

/// The points of a file; says on stderr how they were read, where that is not plain. Throws io::IoError.
io::Cloud read_points(const char* program, const std::string& path);

/// Prints "PROGRAM: WHAT." on stderr.
void complain(const char* program, const std::string& what);

}  // namespace filmsticking::app
