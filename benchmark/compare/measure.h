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
  bool timing_fit = true;  ///< nothing else runs on the machine that we know of
};

/// The columns that are known before the run.
Row planned_row(const Row& cloud, const std::string& method, const Measurement& measurement);

/// Runs a method on a cloud in a process of its own, has `mesh` written, and tells how it went and what is to
/// be said of it. Whatever goes wrong in the method is in the row's status and message.
Row measure(const CloudFiles& files, const std::string& method, const MethodEntry& entry,
            const std::string& mesh, const Measurement& measurement);

}  // namespace filmsticking::bench
