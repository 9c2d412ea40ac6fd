// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "common/usage_error.h"
#include "filters/ground_plane.h"
#include "report/truth_fit.h"

namespace filmsticking::app {

/// The command line of mesh_report.
struct CommandLine {
  std::string mesh;
  std::string truth;   ///< empty: none
  std::string points;  ///< empty: none
  std::string unit;    ///< empty: unknown
  filters::GroundChoice ground;
  std::string html;  ///< file of the page; empty: none
  std::size_t samples = mesh_report::kDefaultSamples;
  bool json = false;
  bool help = false;
};

/// Throws UsageError.
CommandLine parse_command_line(int argc, const char* const* argv);

/// The text of --help.
std::string usage();

}  // namespace filmsticking::app
