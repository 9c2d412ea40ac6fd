// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.h"

namespace filmsticking::bench {

/// Draws what every method makes of every cloud: a row a cloud, a column a method, the ground truth first.
void draw_sheet(const CommandLine& command);

}  // namespace filmsticking::bench
