// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "child_process.h"
#include "cloud_files.h"
#include "programs.h"
#include "row.h"

namespace filmsticking::bench {

struct Measurement {
  Limits limits;           ///< of the method's process
  int threads = 0;         ///< 0: all
  int run = 1;             ///< which of several runs of the same
  bool judge = true;       ///< have mesh_report judge the mesh
  bool timing_fit = true;  ///< compare runs nothing else meanwhile
};

/// The columns that are known before the run.
Row planned_row(const Row& cloud, const std::string& method, const Measurement& measurement);

/// Runs a method on a cloud in a process of its own, which writes `mesh`, and measures
/// both. Failures of the method are in the row's status and message.
Row measure(const CloudFiles& files, const std::string& method, const MethodEntry& entry,
            const std::string& mesh, const Measurement& measurement);

}  // namespace filmsticking::bench
