// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "filmsticking/options.h"

namespace filmsticking::app {

/// What the user asked pcd_to_mesh for.
struct CommandLine {
  std::string input;
  std::string output;
  std::string report;      ///< JSON file; empty: none
  std::string dump_steps;  ///< folder for the film after each step; empty: none
  Options options;
  bool help = false;
  bool version = false;
};

/// A command line that makes no sense; what() is a sentence for the user.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws UsageError.
CommandLine parse_command_line(int argc, const char* const* argv);

/// The text of --help.
std::string usage();

}  // namespace filmsticking::app
