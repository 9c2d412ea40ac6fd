// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.h"

namespace filmsticking::bench {

/// Methods on the scans of a folder: NAME.ply with the camera of each point, and NAME.occupancy.f32 with
/// probes of the true solid, for each NAME. Writes the CSV and a table. Throws std::runtime_error.
void compare_berger(const CommandLine& command);

}  // namespace filmsticking::bench
