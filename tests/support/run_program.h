// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace filmsticking::test {

/// How a program ended and what it said.
struct Outcome {
  int status = -1;  ///< exit status; 128 + the signal if one killed it
  std::string out;
  std::string err;
};

/// Runs a program to its end. `while_running`, if given, is called with its process id.
Outcome run_program(const std::vector<std::string>& command,
                    const std::function<void(pid_t)>& while_running = nullptr);

}  // namespace filmsticking::test
