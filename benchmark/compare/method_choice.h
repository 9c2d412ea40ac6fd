// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "programs.h"

namespace filmsticking::bench {

/// The methods to run, in the given order; by default all that make a mesh of any cloud, but not the faults
/// for tests, ours first. Throws UsageError for an unknown name.
std::vector<std::string> choose_methods(const std::vector<std::string>& asked,
                                        const std::map<std::string, MethodEntry>& all);

}  // namespace filmsticking::bench
