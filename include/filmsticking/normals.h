// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "export.h"
#include "status.h"
#include "types.h"

namespace filmsticking {

/// A unit vector.
using Normal = std::array<float, 3>;

/// One unit normal for every point, by a surface that reconstruct() made of them: outward of a closed one, to
/// the front of an open one.
///
/// `vertices`, `triangles`: as in Result; they must be of `points`. A vertex gets the mean of the faces
/// around it, by angle and size; on a rough surface, as through noise, that of the faces within three edges
/// by area. A point that is no vertex, as an outlier or a repeated point, gets the normal at the nearest
/// place on the surface. A point that is not finite gets NaN.
///
/// `normals`: receives points.size() of them; empty unless the status is Ok. `threads`: 0: all; the normals
/// do not depend on it. `cancel`: as in Execution. Returns Ok, InvalidInput (no face, or an index out of
/// range), Cancelled, OutOfMemory or InternalError; throws nothing. Time: a few per cent of the
/// reconstruction's.
FILMSTICKING_EXPORT Status point_normals(const PointsView& points, const std::vector<std::int32_t>& vertices,
                                         const std::vector<Triangle>& triangles, std::vector<Normal>& normals,
                                         int threads = 0, const std::atomic<bool>* cancel = nullptr) noexcept;

}  // namespace filmsticking
