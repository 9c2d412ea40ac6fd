// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "filmsticking/report.h"

namespace filmsticking::app {

/// Lines for a person about the mesh of a reconstruction that succeeded: the file, closed or not, the genus,
/// the points used.
std::string mesh_summary(const Report& report, const std::string& file);

/// "1.2 s, 35 MB of memory at most": the second is peak_memory_bytes().
std::string cost_summary(double seconds);

/// The largest resident set of this process so far, in bytes.
std::int64_t peak_memory_bytes();

}  // namespace filmsticking::app
