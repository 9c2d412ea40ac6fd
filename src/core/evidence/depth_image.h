// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "geometry/surface.h"
#include "geometry/work_limits.h"
#include "points/site_geometry.h"
#include "surface/surface_quality.h"

namespace filmsticking {

/// A depth image: its viewpoint and its visible surface.
struct DepthImage {
  Vec3 viewpoint;
  Surface surface;         ///< depth_image_surface()
  SurfaceQuality quality;  ///< of the surface
};

/// The depth image whose pixels are `places`, in a box of side 1; nothing if they are no depth image. The
/// viewpoint is where the rows of pixels meet (raster_viewpoint()), else `guess`.
///
/// Seen from its viewpoint, all pixels of an image are to one side and evenly spaced: hardly one is much
/// nearer to another than its neighbours are to theirs. From a wrong viewpoint, or with one surface behind
/// another, many are. If both surfaces are as regular as an image, the image's surface misses sites, has many
/// parts or disagrees with the fitted planes; the places are no image then either. Thinned or noisy pixels
/// may be unevenly spaced if the surface misses hardly a site and does not zigzag (share_between_layers()).
std::optional<DepthImage> depth_image(const std::vector<Vec3>& places, const SiteGeometry& geometry,
                                      const std::optional<Vec3>& guess, const Cancel& cancel = {});

/// The surface of a depth image: the Delaunay triangulation of its pixels. An edge is flipped if the other
/// diagonal is shorter in space. Faces that no data supports, in space or in the image, are removed
/// (remove_bridges()).
///
/// Every face shows its front to the viewpoint, and no line of sight meets two faces. So faces meet in common
/// corners only. A manifold with boundary, perhaps empty. Of sites in the same direction it has the nearest.
/// Ends: flips reduce the sum of edge lengths.
Surface depth_image_surface(const std::vector<Vec3>& places, const Vec3& viewpoint,
                            const SiteGeometry& geometry, const Cancel& cancel = {});

}  // namespace filmsticking
