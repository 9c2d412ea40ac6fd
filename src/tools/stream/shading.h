// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::stream {

/// The brightness of each vertex, from 0.5 (turned away) to 1, under a lamp above and to one side. rviz needs
/// it: it does not light triangles that have colours of their own.
std::vector<float> shades(const Mesh& mesh);

}  // namespace filmsticking::stream
