// SPDX-License-Identifier: GPL-3.0-or-later
// Arguments of command lines that say how a picture is taken. All throw app::UsageError.
#pragma once

#include <string>

#include "camera.h"

namespace filmsticking::scene {

/// --view AZ,EL: two angles in degrees.
void parse_view(const std::string& text, Angles& angles);

/// --up y|z
void parse_up(const std::string& text, Angles& angles);

/// --size WxH: pixels, each side from `least` to `most`.
void parse_size(const std::string& text, int least, int most, int& width, int& height);

}  // namespace filmsticking::scene
