// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "filmsticking/reconstruct.h"
#include "points/site_geometry.h"
#include "points/site_set.h"
#include "surface/finish.h"

namespace filmsticking {

/// Writes vertices, triangles, gaps and their counts into the result, whose report has the number of points.
/// Vertices are input ids in rising order. Triangles start at their least corner and are sorted. Throws
/// Failure, Status::InternalError, where the result breaks a guarantee of reconstruct(); `may_be_open`: it
/// may have a boundary. `stability`: per site, or empty; a face gets the least of its corners.
void write_result(const FinishedSurface& finished, const SiteSet& sites, const SiteGeometry& geometry,
                  const std::vector<float>& stability, bool may_be_open, Result& result);

}  // namespace filmsticking
