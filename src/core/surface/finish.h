// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "filmsticking/types.h"
#include "geometry/monitor.h"
#include "geometry/surface.h"
#include "geometry/triangle_adjacency.h"
#include "points/site_geometry.h"
#include "points/site_set.h"
#include "surface/lids.h"

namespace filmsticking {

/// What a surface is finished for.
struct FinishOptions {
  bool open = false;                              ///< the surface may have a boundary
  bool sharp_edges = true;                        ///< flip edges along the sharp edges of the shape
  const Vec3* viewpoint = nullptr;                ///< all faces show their fronts to it; null: unknown
  const std::vector<Vec3>* viewpoints = nullptr;  ///< [site] what saw it (turn_to_sensors()); null: unknown
  double max_hole = 0;  ///< rims of at most this diameter get a lid, in the sites' unit
};

/// A finished surface. Its vertices have the exact places of their sites.
struct FinishedSurface {
  Surface surface;
  SurfaceTopology topology;       ///< of `surface`; twins as before components were turned over
  std::vector<Opening> openings;  ///< of an open surface: its rims before they got lids
  std::int64_t flips = 0;         ///< edges flipped along sharp edges
  bool usable = false;            ///< false: without faces, or closed and without volume

  explicit FinishedSurface(Surface found);
};

/// The last stage. It moves the vertices to their exact places, removes sliver faces, repairs an open surface
/// (faces that meet others, pinholes), flips edges along sharp edges, gives
/// lids to small rims and orients every component.
///
/// A manifold stays one. A surface that is no manifold comes back as it is: the caller must check
/// `topology.check`. `points`: what the sites were made of. Throws what `monitor` throws.
FinishedSurface finish(Surface found, const PointsView& points, const SiteSet& sites,
                       const SiteGeometry& geometry, const FinishOptions& options, Monitor& monitor);

}  // namespace filmsticking
