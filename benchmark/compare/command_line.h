// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "child_process.h"
#include "clouds/cloud_spec.h"
#include "common/usage_error.h"

namespace filmsticking::bench {

/// The command line of compare.
struct CommandLine {
  enum class Mode { Quality, Speed, Sheet, Sample, Scans, Normals, Berger };
  Mode mode = Mode::Quality;
  bool help = false;
  std::vector<std::string> inputs;
  std::vector<std::string> methods;  ///< empty: those of the mode
  std::vector<std::string> kinds;    ///< of scans; empty: all
  std::vector<Sampling> samplings;
  std::vector<std::int64_t> points;
  std::vector<std::uint64_t> seeds;
  std::vector<Noise> noise;
  std::vector<double> outliers, missing;

  int threads = 0;
  int jobs = 1;
  int runs = 3;
  Limits limits = {600, 0};
  std::string csv, markdown;  ///< empty: no such file; the Markdown then goes to the standard output
  bool fresh = false;
  bool by_shape = false;
  std::string peer = "cgal-advancing-front";
  std::string keep;  ///< folder for the clouds and meshes; empty: they are removed

  std::string output;    ///< the picture, or the cloud
  std::string view, up;  ///< for mesh_snapshot
};

using app::UsageError;

/// Throws UsageError, and std::runtime_error for a list file that cannot be read.
CommandLine parse_command_line(int argc, const char* const* argv);

/// The words between the commas.
std::vector<std::string> split_list(const std::string& list);

/// The text of --help.
std::string usage();

}  // namespace filmsticking::bench
