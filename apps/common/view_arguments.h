// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "arguments.h"
#include "scene/camera.h"

namespace filmsticking::app {

/// Adds --view AZ,EL (two angles in degrees) and --up y|z.
void add_view(Arguments& arguments, scene::Angles& angles);

/// Adds --size WxH: pixels, each side from `least` to `most`.
void add_size(Arguments& arguments, const std::string& help, int least, int most, int& width, int& height);

}  // namespace filmsticking::app
