// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "filmsticking/reconstruct.h"

namespace filmsticking::test {

/// The mesh that a result names.
Mesh mesh_of(const Result& result, const std::vector<Point>& points);

/// Empty if the result of reconstruct(points) is what is promised for any points; else what is wrong. A mesh:
/// closed, manifold, oriented, its volume is positive (decided exactly), its vertices are distinct points
/// of the input. Or a status that the points deserve, with a sentence and an empty mesh. `open`: of
/// Options::open_boundary, whose mesh may have a boundary and then has no volume.
std::string fault_of(const Result& result, const std::vector<Point>& points, bool open = false);

}  // namespace filmsticking::test
