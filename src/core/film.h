// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "filmsticking/options.h"
#include "filmsticking/report.h"
#include "guiding_surface.h"
#include "manifold_repair.h"
#include "power_diagram.h"

namespace filmsticking {

/// One film step (paper, section 4): cut the film by the power diagram, take the dual, repair it. A pure
/// function. Vertices of the result are sites of the diagram; empty where the film has no triple point.
GuidingSurface film_step(const GuidingSurface& film, const PowerDiagram& diagram, RingChoice ring,
                         RepairCounts& counts);

/// A film from triangles of sites, in the order in which they come.
GuidingSurface unsorted_film_of_sites(std::vector<Corners> triangles, const std::vector<Vec3>& sites);

/// A film from triangles of sites, in a canonical order.
GuidingSurface film_of_sites(std::vector<Corners> triangles, const std::vector<Vec3>& sites);

/// The same number for the same triangles of sites; others differ but for chance.
std::uint64_t connectivity_hash(const GuidingSurface& film);

/// How a film evolves.
struct FilmOptions {
  RingChoice ring = RingChoice::Smooth;
  bool weights = true;
  int max_steps = 60;
  int round = 0;                                                             ///< copied to the records
  std::function<bool(const StepRecord&, const GuidingSurface&)> after_step;  ///< false: stop
};

/// Evolves a film until every site is on it and its triangles stay the same, or nothing changes any more, or
/// the steps are used up. `sites` are the points followed by the virtual sites; `points` is the number of the
/// former, which `voronoi` (their Delaunay triangulation, without virtual sites) holds too. Virtual sites
/// leave when they reach the film.
GuidingSurface evolve_film(GuidingSurface film, const std::vector<Vec3>& sites, std::size_t points,
                           const PowerDiagram& voronoi, const FilmOptions& options);

/// Number of sites among the film's vertices with an id below `points`.
std::int64_t attracted_points(const GuidingSurface& film, std::size_t points);

}  // namespace filmsticking
