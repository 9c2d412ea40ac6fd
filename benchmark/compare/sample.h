// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.h"

namespace filmsticking::bench {

/// Writes one cloud to the file that the user named.
void write_sample(const CommandLine& command);

}  // namespace filmsticking::bench
