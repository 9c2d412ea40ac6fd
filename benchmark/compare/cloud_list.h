// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "clouds/cloud_spec.h"
#include "command_line.h"
#include "input.h"

namespace filmsticking::bench {

/// A cloud to make.
struct CloudPlan {
  Input input;
  CloudSpec spec;
};

/// All combinations that the command line asks for, inputs innermost.
std::vector<CloudPlan> list_clouds(const CommandLine& command);

}  // namespace filmsticking::bench
