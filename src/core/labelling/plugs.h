// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "labelling/labelling.h"

namespace filmsticking {

/// Plugs of chance gaps: the connected parts of what is outside and narrower than `radius`, smallest first.
/// Not parts that are narrow all over by the radius of an earlier search, which had them.
std::vector<Move> plugs(const Labelling& labelling, double radius, double earlier);

}  // namespace filmsticking
