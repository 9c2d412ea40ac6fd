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
  return surface_of_sites(repair_half_edges(dual, diagram.position, ring, counts), diagram.position);
}

namespace {

// After so many steps without a further site on the film it counts as stalled.
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

class Evolution {
 public:
  Evolution(Surface film, const std::vector<Vec3>& sites, std::size_t points, const PowerDiagram& voronoi,
            const FilmOptions& options)
      : film_(std::move(film)),
        sites_(sites),
        points_(points),
        voronoi_(voronoi),
        options_(options),
        present_(sites.size(), 1),
        virtual_left_(static_cast<std::int64_t>(sites.size() - points)) {
    if (virtual_left_ == 0) return;
    triangulation_ = std::make_unique<DelaunayTriangulation>(sites);
    with_virtual_ = triangulation_->voronoi();
  }

  // Ends: virtual sites only leave. Between two stalls kPatience bounds the steps for each rise of best_on_.
  // A stall without a rise since the stall before is the last, and max_steps bounds it all.
  Surface run() {
    for (int step = 0; step < options_.max_steps; ++step) {
      const auto start = std::chrono::steady_clock::now();
      StepRecord record;
      record.round = options_.round;
      Surface next = next_film(record);
      if (next.triangles.empty()) break;
      const bool left = release_virtual_sites(next);
      film_ = std::move(next);
      record.attracted = sites_on(film_, points_);
      record.virtual_left = virtual_left_;
      record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      if (options_.after_step && !options_.after_step(record, film_)) break;
      if (!goes_on(record.attracted, left)) break;
    }
    return std::move(film_);
  }

 private:
  Surface next_film(StepRecord& record) const {
    const PowerDiagram* diagram = virtual_left_ > 0 ? &with_virtual_ : &voronoi_;
    PowerDiagram weighted;
    if (weighted_next_) {
      std::vector<double> weights;
      record.weighted =
          static_cast<std::int64_t>(attraction_weights(film_, sites_, sites_off(film_, points_), weights));
      weighted = weighted_power_diagram(sites_, weights, present_);
      diagram = &weighted;
    }
    RepairCounts counts;
    Surface next = film_step(film_, *diagram, options_.ring, counts);
    record.regions_repaired = counts.total();
    return next;
  }

  // Removes from the diagram the virtual sites that are on the film. Did any leave?
  bool release_virtual_sites(Surface& film) {
    bool left = false;
    for (Index& s : film.site)
      if (s != kNone && static_cast<std::size_t>(s) >= points_) {
        triangulation_->remove(s);
        present_[s] = 0, left = true, --virtual_left_;
        s = kNone;  // its place stays a vertex of the film, of no site, until the next step
      }
    if (left && virtual_left_ > 0) with_virtual_ = triangulation_->voronoi();
    return left;
  }

  bool goes_on(std::int64_t on, bool virtual_site_left) {
    const bool all_on = on == static_cast<std::int64_t>(points_);
    const bool repeated = !seen_.insert(connectivity_hash(film_)).second;
    since_best_ = on > best_on_ ? 0 : since_best_ + 1;
    best_on_ = std::max(best_on_, on);
    const bool was_weighted = std::exchange(weighted_next_, false);  // weights only overcome a stall
    if (all_on && virtual_left_ > 0) {
      // With all points on the film, the remaining virtual sites go (paper, section 4.3).
      virtual_left_ = 0;
      std::fill(present_.begin() + static_cast<std::ptrdiff_t>(points_), present_.end(), 0);
      seen_.clear();
      return true;
    }
    // A virtual site that left changes the next step even where the film looks the same.
    if (virtual_site_left || was_weighted || (!repeated && since_best_ < kPatience)) return true;
    if (!options_.weights || all_on || best_on_ <= best_at_stall_) return false;
    best_at_stall_ = best_on_;
    weighted_next_ = true;
    since_best_ = 0;
    seen_.clear();
    return true;
  }

  Surface film_;
  const std::vector<Vec3>& sites_;
  const std::size_t points_;
  const PowerDiagram& voronoi_;
  const FilmOptions& options_;
  std::vector<char> present_;
  std::int64_t virtual_left_;
  // While there are virtual sites: a triangulation that they can leave, and its diagram.
  std::unique_ptr<DelaunayTriangulation> triangulation_;
  PowerDiagram with_virtual_;
  // Every film met since the last stall. Coming back to one means that nothing new will happen.
  std::unordered_set<std::uint64_t> seen_;
  bool weighted_next_ = false;
  std::int64_t best_on_ = -1, since_best_ = 0, best_at_stall_ = -1;
};

}  // namespace

Surface evolve_film(Surface film, const std::vector<Vec3>& sites, std::size_t points,
                    const PowerDiagram& voronoi, const FilmOptions& options) {
  return Evolution(std::move(film), sites, points, voronoi, options).run();
}

}  // namespace filmsticking
