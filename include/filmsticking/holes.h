// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "export.h"
#include "report.h"
#include "status.h"
#include "types.h"

namespace filmsticking {

/// The holes of any triangles: loops of edges with one face, the widest first. A loop passes a vertex once.
/// One that ends at an edge of three faces counts as if it were closed. `holes`: empty unless the status is
/// Ok. Returns Ok, InvalidInput (a corner that is no position, or a position of a corner that is not finite),
/// OutOfMemory or InternalError; throws nothing.
FILMSTICKING_EXPORT Status find_holes(const std::vector<Point>& positions,
                                      const std::vector<Triangle>& triangles,
                                      std::vector<Hole>& holes) noexcept;

}  // namespace filmsticking
