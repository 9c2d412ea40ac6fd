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

/// One film step (paper, section 4): cut the film by the power diagram, take the dual, repair it. A pure
/// function. Vertices of the result are sites of the diagram; empty where the film has no triple point.
Surface film_step(const Surface& film, const PowerDiagram& diagram, RingChoice ring, RepairCounts& counts);

/// The same number for the same triangles of sites; others differ but for chance.
std::uint64_t connectivity_hash(const Surface& film);

/// How a film evolves.
struct FilmOptions {
  RingChoice ring = RingChoice::Smooth;
  bool weights = true;
  int max_steps = 60;
  int round = 0;                                                      ///< copied to the records
  std::function<bool(const StepRecord&, const Surface&)> after_step;  ///< false: stop
};

/// Evolves a film until every site is on it and its triangles stay the same, or nothing changes any more, or
/// the steps are used up. `sites` are the points followed by the virtual sites; `points` is the number of the
/// former, which `voronoi` (their Delaunay triangulation, without virtual sites) holds too. Virtual sites
/// leave when they reach the film.
Surface evolve_film(Surface film, const std::vector<Vec3>& sites, std::size_t points,
                    const PowerDiagram& voronoi, const FilmOptions& options);

}  // namespace filmsticking
