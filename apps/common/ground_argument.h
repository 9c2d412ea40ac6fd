// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arguments.h"
#include "filters/ground_plane.h"

namespace filmsticking::app {

/// --ground [A,B,C,D].
void add_ground(Arguments& arguments, const std::string& help, filters::GroundChoice& ground);

}  // namespace filmsticking::app
