// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "filmsticking/options.h"
#include "filmsticking/report.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// Throws Failure, Status::OutOfMemory, where the points alone need more than Options::max_memory.
/// `report`: its number of points.
void check_memory_for_points(const Report& report, const Options& options);

/// What the triangulation of the sites may take. Throws Failure, Status::OutOfMemory, where even the usual
/// number of tetrahedra of a surface needs more than Options::max_memory. `report`: its points and sites.
TriangulationLimits triangulation_limits(const Report& report, const Options& options, const Cancel& cancel);

/// Throws Failure for a triangulation that passed these limits: Status::OutOfMemory where memory set them,
/// else Status::TooComplex.
[[noreturn]] void refuse_triangulation(const TriangulationLimits& limits, const Report& report,
                                       const Options& options);

}  // namespace filmsticking
