// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arguments.h"
#include "filmsticking/options.h"

namespace filmsticking::app {

/// Adds the options of a reconstruction, under a heading of their own.
void add_reconstruction(Arguments& arguments, Options& options);

}  // namespace filmsticking::app
