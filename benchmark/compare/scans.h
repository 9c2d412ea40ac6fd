// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.h"

namespace filmsticking::bench {

/// Every method on every kind of scan; writes the CSV as it goes and the tables at the end.
void compare_scans(const CommandLine& command);

}  // namespace filmsticking::bench
