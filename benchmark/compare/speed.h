// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.h"

namespace filmsticking::bench {

/// Times methods on clouds of growing size, each several times and in turns, ours on all threads and on one;
/// writes the CSV as it goes and the tables at the end.
void compare_speed(const CommandLine& command);

}  // namespace filmsticking::bench
