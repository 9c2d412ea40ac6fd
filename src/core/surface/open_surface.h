// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// The gap that each face bridges: the diameter of its smallest enclosing circle, in the largest spacing of
/// its corners. Dimensionless; about 1.5 on an evenly sampled surface. A bridge face is one with a large gap.
std::vector<float> face_gaps(const Surface& surface, const SiteGeometry& geometry);

/// Is the gap of a face with these corners below the low threshold of remove_bridges()?
bool is_narrow(const Surface& surface, const Corners& face, const SiteGeometry& geometry);

/// [site]: 1 if its faces form one ring or one fan once the bridge faces are removed. `triangles`: of sites,
/// oriented; they need not be a manifold.
std::vector<char> manifold_without_bridges(const std::vector<Corners>& triangles,
                                           const std::vector<Vec3>& sites, const SiteGeometry& geometry);

/// Removes the faces with keep[face] == 0; then, at each vertex with several fans, all but the fan with most
/// faces. A manifold, with or without boundary, stays one, perhaps empty. Vertices without a face are
/// removed. `geometry`: of all sites. Ends: every pass but the last removes faces.
void keep_faces(Surface& surface, std::vector<char> keep, const SiteGeometry& geometry);

/// Removes bridge faces, which no data support: connected regions of faces with gaps above a low threshold
/// that contain one above a high threshold (hysteresis). Then what keep_faces() removes.
void remove_bridges(Surface& surface, const SiteGeometry& geometry);

/// The same by these gaps, one per face.
void remove_bridges(Surface& surface, const std::vector<float>& gaps, const SiteGeometry& geometry);

}  // namespace filmsticking
