// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/film.h"

#include <algorithm>
#include <chrono>
#include <unordered_set>
#include <utility>

#include "film/attraction_weights.h"
#include "film/dual_complex.h"
#include "film/restricted_power_diagram.h"
#include "geometry/triangle_adjacency.h"

namespace filmsticking {

std::uint64_t connectivity_hash(const Surface& film) {
  std::uint64_t h = 1469598103934665603ULL;
  for (const Corners& t : film.triangles)
    for (Index v : t) h = (h ^ static_cast<std::uint64_t>(film.site[v] + 1)) * 1099511628211ULL, h ^= h >> 29;
  return h;
}

Surface film_step(const Surface& film, const PowerDiagram& diagram, RingChoice ring, RepairCounts& counts) {
  if (diagram.any_site == kNone || film.triangles.empty()) return {};
  std::vector<Index> twin = half_edge_twins(film.triangles, static_cast<Index>(film.positions.size()));
  const RestrictedPowerDiagram restricted = restrict_power_diagram(film, std::move(twin), diagram);
  const HalfEdgeComplex dual = dual_complex(film, restricted, diagram);
  return surface_of_sites(manifold_repair(dual, diagram.position, ring, counts), diagram.position);
}

namespace {

// Steps without a new site on the film after which it counts as stalled.
constexpr std::int64_t kPatience = 3;

std::vector<Index> sites_off(const Surface& film, std::size_t points) {
  std::vector<char> on(points, 0);
  for (Index s : film.site)
    if (s != kNone && static_cast<std::size_t>(s) < points) on[s] = 1;
  std::vector<Index> off;
  for (std::size_t s = 0; s < points; ++s)
    if (!on[s]) off.push_back(static_cast<Index>(s));
  return off;
}

}  // namespace

Surface evolve_film(Surface film, const std::vector<Vec3>& sites, std::size_t points,
                    const PowerDiagram& voronoi, const FilmOptions& options) {
  // With virtual sites, a triangulation of their own that they can leave; without, the points' diagram.
  std::unique_ptr<DelaunayTriangulation> triangulation;
  PowerDiagram with_virtual;
  std::vector<char> present(sites.size(), 1);
  std::int64_t virtual_left = static_cast<std::int64_t>(sites.size() - points);
  if (virtual_left > 0) {
    triangulation = std::make_unique<DelaunayTriangulation>(sites);
    with_virtual = triangulation->voronoi();
  }
  // Every film met since the last stall: coming back to one means that nothing new will happen.
  std::unordered_set<std::uint64_t> seen;
  bool weighted_next = false;
  std::int64_t best = -1, since_best = 0, best_at_stall = -1;
  // Ends: virtual sites only leave; between two stalls the steps are bounded by kPatience for each rise of
  // `best`; a stall without a rise since the one before ends it; and max_steps bounds it all.
  for (int step = 0; step < options.max_steps; ++step) {
    const auto start = std::chrono::steady_clock::now();
    StepRecord record;
    record.round = options.round;
    const PowerDiagram* diagram = virtual_left > 0 ? &with_virtual : &voronoi;
    PowerDiagram weighted;
    if (weighted_next) {
      std::vector<double> weights;
      record.weighted =
          static_cast<std::int64_t>(attraction_weights(film, sites, sites_off(film, points), weights));
      weighted = weighted_power_diagram(sites, weights, present);
      diagram = &weighted;
    }
    RepairCounts counts;
    Surface next = film_step(film, *diagram, options.ring, counts);
    if (next.triangles.empty()) break;

    bool left = false;
    for (Index& s : next.site)
      if (s != kNone && static_cast<std::size_t>(s) >= points) {
        triangulation->remove(s);
        present[s] = 0, left = true, --virtual_left;
        s = kNone;  // its place stays a vertex of the film, of no site, until the next step
      }
    if (left && virtual_left > 0) with_virtual = triangulation->voronoi();
    film = std::move(next);
    record.attracted = sites_on(film, points);
    record.virtual_left = virtual_left;
    record.regions_repaired = counts.total();
    record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (options.after_step && !options.after_step(record, film)) break;

    const bool all_on = record.attracted == static_cast<std::int64_t>(points);
    const bool repeated = !seen.insert(connectivity_hash(film)).second;
    since_best = record.attracted > best ? 0 : since_best + 1;
    best = std::max(best, record.attracted);
    const bool was_weighted = std::exchange(weighted_next, false);  // weights only overcome a stall
    if (all_on && virtual_left > 0) {
      // Once all points are on the film, the remaining virtual sites go (paper, section 4.3).
      virtual_left = 0;
      std::fill(present.begin() + static_cast<std::ptrdiff_t>(points), present.end(), 0);
      seen.clear();
      continue;
    }
    // A virtual site that left changes the next step even where the film looks the same.
    if (left || was_weighted || (!repeated && since_best < kPatience)) continue;
    if (!options.weights || all_on || best <= best_at_stall) break;
    best_at_stall = best;
    weighted_next = true;
    since_best = 0;
    seen.clear();
  }
  return film;
}

}  // namespace filmsticking
