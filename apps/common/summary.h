// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "filmsticking/report.h"

namespace filmsticking::app {

/// Lines for a person about the mesh of a reconstruction that succeeded: the file, closed or not, the genus,
/// the points used.
std::string mesh_summary(const Report& report, const std::string& file);

/// "1.2 s, 35 MB of memory at most", the memory being that of this process so far.
std::string cost_summary(double seconds);

/// The most memory that this process has had, in bytes.
std::int64_t peak_memory_bytes();

}  // namespace filmsticking::app
