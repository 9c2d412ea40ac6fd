// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "programs.h"

namespace filmsticking::bench {

/// The methods to run in the order asked for; by default all that make a mesh and are not for the tests, ours
/// first. Throws UsageError for a name that there is not.
std::vector<std::string> choose_methods(const std::vector<std::string>& asked,
                                        const std::map<std::string, MethodEntry>& all);

}  // namespace filmsticking::bench
