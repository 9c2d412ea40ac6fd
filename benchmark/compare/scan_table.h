// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "scan_result.h"

namespace filmsticking::bench {

/// A table for each method with a row for each kind, and below it what is wrong; kinds and methods in the
/// order in which they come first.
std::string scan_tables(const std::vector<ScanResult>& results);

}  // namespace filmsticking::bench
