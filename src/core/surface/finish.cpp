// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/finish.h"

#include <utility>
#include <vector>

#include "geometry/parallel.h"
#include "surface/cap_faces.h"
#include "surface/feature_flips.h"
#include "surface/front.h"
#include "surface/meeting_faces.h"
#include "surface/orientation.h"
#include "surface/pinholes.h"
#include "surface/viewpoint.h"

namespace filmsticking {

FinishedSurface::FinishedSurface(Surface found)
    : surface(std::move(found)), topology(surface.triangles, static_cast<Index>(surface.positions.size())) {}

FinishedSurface finish(Surface found, const PointsView& points, const SiteSet& sites,
                       const SiteGeometry& geometry, const FinishOptions& options, Monitor& monitor) {
  FinishedSurface done(std::move(found));
  Surface& surface = done.surface;
  SurfaceTopology& topology = done.topology;
  done.usable = !surface.triangles.empty();
  if (!topology.check.manifold()) return done;

  // Where sites lie on a plane, a face between perturbed sites could be turned over.
  parallel_each(surface.site.size(),
                [&](std::size_t v) { surface.positions[v] = sites.exact(points, surface.site[v]); });
  const auto update_after = [&](std::int64_t changes) {
    if (changes > 0)
      topology = SurfaceTopology(surface.triangles, static_cast<Index>(surface.positions.size()));
  };
  update_after(remove_cap_faces(surface, topology.twin));
  if (options.open && !topology.check.closed) {
    // The faces of a depth image do not meet.
    if (options.viewpoint == nullptr) update_after(remove_meeting_faces(surface, geometry, monitor.cancel()));
    update_after(fill_pinholes(surface, topology.twin, geometry, options.viewpoint));
  }
  if (options.sharp_edges) {
    monitor.enter("sharp edges", monitor.share());
    done.flips = flip_to_features(surface, topology.twin, monitor.cancel(), options.viewpoint);
    topology.check =
        check_manifold_with_twins(surface.triangles, static_cast<Index>(surface.site.size()), topology.twin);
  }
  if (!topology.check.manifold()) return done;
  if (options.open && !topology.check.closed) {
    const std::size_t before = surface.triangles.size();
    done.openings = close_rims(surface, topology.twin, options.max_hole, monitor.cancel());
    update_after(static_cast<std::int64_t>(surface.triangles.size() - before));
  }

  std::vector<std::int32_t> ids(surface.site.size());
  parallel_each(ids.size(), [&](std::size_t v) { ids[v] = sites.input[surface.site[v]]; });
  if (options.open && options.viewpoints == nullptr && options.viewpoint == nullptr)
    turn_to_viewpoint(surface, topology, monitor.cancel());
  done.usable = orient_components(surface, points.at(ids), topology);
  if (options.open && options.viewpoints != nullptr)
    turn_to_sensors(surface, topology.component, *options.viewpoints);
  return done;
}

}  // namespace filmsticking
