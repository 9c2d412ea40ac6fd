// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arguments.h"
#include "filmsticking/options.h"

namespace filmsticking::app {

/// The options of a reconstruction, as --help shows them.
boost::program_options::options_description reconstruction_arguments();

/// Throws UsageError.
Options reconstruction_options(const Arguments& given);

}  // namespace filmsticking::app
