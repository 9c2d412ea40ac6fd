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

/// A depth image: where it was taken from, and the surface that is seen.
struct DepthImage {
  Vec3 viewpoint;
  Surface surface;         ///< depth_image_surface()
  SurfaceQuality quality;  ///< its own
};

/// The depth image whose pixels the places are, in a box of side 1; nothing if they are none. Its viewpoint
/// is where their rows meet (raster_viewpoint()), or else `guess`.
///
/// From the viewpoint of a depth image all pixels are to one side and lie apart from each other: hardly one
/// is much nearer to another than those around are to theirs. From a wrong one, or where there is one surface
/// behind another, many are, unless both are as regular as an image: then the surface leaves sites off, is in
/// many parts or winds through both, against the planes fitted to neighbours, and they are no image, either.
/// Pixels may lie anyhow, as in thinned or noisy images, where the surface leaves hardly a site off and does
/// not go to and fro between two layers (share_between_layers()).
std::optional<DepthImage> depth_image(const std::vector<Vec3>& places, const SiteGeometry& geometry,
                                      const std::optional<Vec3>& guess, const Cancel& cancel = {});

/// What the places are if all that can be seen of them is seen from that viewpoint, in no order: to one side
/// of it, on a surface that leaves out hardly one. Nothing if they are not. Two surfaces one close behind the
/// other may be, too: what else is known must tell.
std::optional<DepthImage> image_from(const std::vector<Vec3>& places, const Vec3& viewpoint,
                                     const SiteGeometry& geometry, const Cancel& cancel = {});

/// The surface of a depth image: the Delaunay triangulation of its pixels, with edges flipped where they are
/// shorter in space, without the faces that no data supports, in space or in the image (remove_bridges()).
///
/// Every face shows its front to the viewpoint, and no line from there meets two: so none meets another but
/// in common corners. A manifold with boundary, perhaps empty. Of sites in one direction exactly, the
/// nearest is on it. Ends: flips make a sum of lengths shorter.
Surface depth_image_surface(const std::vector<Vec3>& places, const Vec3& viewpoint,
                            const SiteGeometry& geometry, const Cancel& cancel = {});

/// Which side of the image each tetrahedron's middle is on: 1 behind it, or, where there is hardly anything
/// behind it, before it; -1 the other side, and at infinity.
std::vector<double> depth_image_sides(const TetrahedralMesh& mesh, const std::vector<Vec3>& places,
                                      const Vec3& viewpoint, const Cancel& cancel = {});

}  // namespace filmsticking
