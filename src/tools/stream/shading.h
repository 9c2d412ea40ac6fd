// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/model.h"

namespace filmsticking::stream {

/// How light each vertex is, from 0.5 (turned away) to 1, under a lamp high up on one side. For viewers that
/// do not light triangles with colours of their own, as rviz does not.
std::vector<float> shades(const io::Model& mesh);

}  // namespace filmsticking::stream
