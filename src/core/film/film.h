// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "delaunay/power_diagram.h"
#include "film/half_edge_repair.h"
#include "filmsticking/options.h"
#include "filmsticking/report.h"
#include "geometry/surface.h"

namespace filmsticking {

/// One film step (paper, section 4): divide the film by the power diagram, take the dual, repair it. A pure
/// function. The result is a closed manifold whose vertices are sites of the diagram; empty if no three cells
/// meet on the film. `counts`: receives what the repair did.
Surface film_step(const Surface& film, const PowerDiagram& diagram, RingChoice ring, RepairCounts& counts);

/// A hash of the triangles, by their sites.
std::uint64_t connectivity_hash(const Surface& film);

/// Options of evolve_film().
struct FilmOptions {
  RingChoice ring = RingChoice::Smooth;
  bool weights = true;
  int max_steps = 60;
  int round = 0;                                                      ///< copied to every record
  std::function<bool(const StepRecord&, const Surface&)> after_step;  ///< returns false to stop
};

/// The entry of film/: evolves a film from a start by film steps until they change nothing more, until the
/// film stalls or after max_steps. The start is any closed manifold around the sites (initial_surface.h).
///
/// `sites`: the points, then the virtual sites. `points`: the number of points. `voronoi`: the diagram of the
/// points alone. A virtual site is removed when the film reaches it, and all are once every point is on the
/// film (paper, section 4.3). Where the film stalls, weights attract the sites off it for one step (4.2).
Surface evolve_film(Surface film, const std::vector<Vec3>& sites, std::size_t points,
                    const PowerDiagram& voronoi, const FilmOptions& options);

}  // namespace filmsticking
