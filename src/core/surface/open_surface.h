// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/surface.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// The gap that each face of a film of sites bridges: the diameter of the smallest circle around the face, in
/// spacings of its corner with the largest. Without unit; about 1.5 on an evenly sampled surface.
std::vector<float> face_gaps(const Surface& film, const SiteGeometry& geometry);

/// Is a face with these corners no bridge by itself: is its gap below the low threshold of remove_bridges()?
bool is_narrow(const Surface& film, const Corners& face, const SiteGeometry& geometry);

/// Where the surface of some labels, itself not a manifold yet, will be one once its bridges are gone: 1 for
/// a site whose other faces form one ring or one fan. `triangles`: of sites.
std::vector<char> manifold_without_bridges(const std::vector<Corners>& triangles,
                                           const std::vector<Vec3>& sites, const SiteGeometry& geometry);

/// Takes away the faces that are not to be kept. Then, where a vertex has several fans left, all but that
/// with most faces. So what is left of a manifold with boundary, or without, is one, perhaps empty; vertices
/// without a face are gone. Ends: every pass but the last takes faces away. `geometry`: of all sites.
void keep_faces(Surface& film, std::vector<char> keep, const SiteGeometry& geometry);

/// Takes away the faces that no data supports: connected regions of faces with gaps above a low threshold
/// that have one above a high one; and what keep_faces() takes then.
void remove_bridges(Surface& film, const SiteGeometry& geometry);

/// The same with other gaps, one a face.
void remove_bridges(Surface& film, const std::vector<float>& gaps, const SiteGeometry& geometry);

}  // namespace filmsticking
