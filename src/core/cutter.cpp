// SPDX-License-Identifier: GPL-3.0-or-later
#include "cutter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "evidence/ball.h"
#include "evidence/signed_field.h"
#include "geometry/parallel.h"
#include "labelling/labelling.h"
#include "labelling/mend.h"
#include "labelling/reach.h"
#include "labelling/repair.h"
#include "labelling/sculpt.h"
#include "labelling/two_sides.h"
#include "labelling/unfold.h"
#include "labelling/warp.h"
#include "surface/energy.h"
#include "surface/open_surface.h"
#include "surface/surface_normals.h"

namespace filmsticking {
namespace {

// The weight of the two sides of an open surface, which are known better than an inside: closing it costs the
// area of a lid.
constexpr double kSidesConviction = 1;
// Factor on the conviction around the sites that a cut missed. A weak conviction gives up thin plates; a
// strong one everywhere would not be smooth.
constexpr double kConvictionGrowth = 4;
// The same where a cut keeps hardly a site: it says nothing about where to grow, and takes long.
constexpr double kFastGrowth = 16, kNothing = 0.9;
// Most cuts by one belief.
constexpr int kCuts = 6;
// Fraction of sites that a cut keeps. The first cut above it decides the topology; later cuts only add sites.
constexpr double kKeptShare = 0.8;
// Fraction of missed sites that the next cut still misses. Above: stop.
constexpr double kStalled = 0.95;
// Growth of the belief in the outside per spacing of width. Slow: the evidence decides about chance gaps in
// thin walls.
constexpr double kCarveSlope = 0.2;
// Growth of the belief in the inside per spacing.
constexpr double kInsideSlope = 3;
// Most cuts by evidence from the surface's own normals. Later ones change little.
constexpr int kRefinements = 2;
// Fraction of area in bridge faces by which the next cut may exceed the last. More: it is no finer cut of the
// surface, but another one, with a lid.
constexpr double kNewLid = 0.05;
// Most that repair saves of a cut's energy: torn labels have more area. Measured: 0.42, over 275 cuts.
constexpr double kRepairGain = 0.45;

}  // namespace

// The labels of several cuts by one belief.
struct Cutter::Cuts {
  // `first`: the first cut that keeps 80 % of the sites, else the best. `best`: the cut that keeps most.
  std::vector<char> first, best;
  double missed = 0;       // fraction of the sites that the first of all cuts missed
  bool has_shape = false;  // the best keeps at least half of the sites
};

Cutter::Cutter(const PointsView& points, const SiteSet& sites, const SiteGeometry& geometry,
               const Options& options, Monitor& monitor)
    : points_(points), sites_(sites), geometry_(geometry), options_(options), monitor_(monitor) {}

void Cutter::take(Tetrahedra tetrahedra) {
  mesh_ = make_tetrahedral_mesh(std::move(tetrahedra), sites_.perturbed);
  monitor_.enter("local evidence", 0.15);
  evidence_ = facet_evidence(mesh_, sites_.perturbed, geometry_);
}

void Cutter::use_sight(std::vector<float> votes) {
  sight_ = std::move(votes);
  known_.resize(sight_.size());
  const EnergyPrices prices;
  parallel_each(sight_.size(), [&](std::size_t t) {
    double area = std::numeric_limits<double>::infinity();  // of a sample
    for (Index v : mesh_.tets.corners[t])
      if (v != kNone) area = std::min(area, geometry_.spacing[v] * geometry_.spacing[v]);
    known_[t] = prices.sight * area * double{sight_[t]};
  });
}

std::vector<float> Cutter::forget_sight() {
  known_.clear();
  return std::exchange(sight_, {});
}

std::vector<double> Cutter::turn_sight_over() {
  std::vector<double> belief(sight_.size());
  parallel_each(sight_.size(), [&](std::size_t t) {
    sight_[t] = -sight_[t], known_[t] = -known_[t];
    belief[t] = sight_[t] > 0 ? 1 : -1;
  });
  return belief;
}

// What sight is against labels, in lines.
double Cutter::blocked_lines(const std::vector<char>& labels) const {
  if (sight_.empty() || labels.empty()) return 0;
  return parallel_sum(labels.size(), [&](std::size_t t) {
    return labels[t] ? std::max(0.0, -double{sight_[t]}) : std::max(0.0, double{sight_[t]});
  });
}

std::vector<double> Cutter::off_prices() const {
  std::vector<double> prices(sites_.size());
  parallel_each(prices.size(), [&](std::size_t v) {
    const double spacing = std::min(geometry_.spacing[v], near_spacing(geometry_, static_cast<Index>(v)));
    prices[v] = EnergyPrices().off * spacing * spacing;
  });
  return prices;
}

Candidate Cutter::cut(std::vector<double> belief, double conviction, bool open, const CutLimits& limits) {
  parallel_each(belief.size(), [&](std::size_t t) {  // what a label against the belief costs
    const auto& area = evidence_.area[t];
    belief[t] *= conviction * (double{area[0]} + area[1] + area[2] + area[3]);
    if (!known_.empty()) belief[t] += known_[t];
  });
  LabelCosts costs{evidence_.cost, std::move(belief), off_prices()};
  Candidate candidate;
  candidate.open = open;
  Cuts cuts = several_cuts(costs.hold, limits);
  candidate.missed = cuts.missed;
  if (!cuts.has_shape) return candidate;
  if (limits.rival != nullptr && least_energy(cuts.best, open) > limits.rival->energy) return candidate;

  monitor_.enter("manifold", monitor_.share());
  std::vector<char>& labels = cuts.first;
  Labelling labelling(mesh_, geometry_, costs, labels, monitor_.cancel());
  repair(labelling, exempt(labels, open));
  warp(labelling, cuts.best);
  settle(labelling, candidate);
  candidate.labels = std::move(labels);
  candidate.hold = std::move(costs.hold);
  return measured(std::move(candidate));
}

// The end of all moves. Sets the surface.
void Cutter::settle(Labelling& labelling, Candidate& candidate) const {
  unfold(labelling);
  if (options_.insert_leftover) reach(labelling);
  candidate.inserted += labelling.counts.reached;
  candidate.surface = surface_of(labelling.labels(), candidate.open);
}

// A bound of what labels will cost once they are repaired. Sites off may still join the surface.
double Cutter::least_energy(const std::vector<char>& labels, bool open) const {
  SurfaceQuality quality = surface_quality(surface_of(labels, open), geometry_);
  const std::int64_t off = std::exchange(quality.off, 0);
  quality.complexity = 0;
  return (1 - kRepairGain) * surface_energy(quality, off, sites_.size());
}

// The first cut that keeps most sites decides the topology; the cut with most sites is what the moves aim at.
// Conviction grows around the sites that the cut before missed.
Cutter::Cuts Cutter::several_cuts(const std::vector<double>& hold, const CutLimits& limits) {
  const std::size_t n = sites_.size();
  Cuts cuts;
  std::optional<Sculptor> sculptor;
  std::vector<double> grown;  // instead of `hold`, if there is a second cut
  std::size_t first_off = n + 1, best_off = n + 1, last_off = n;
  for (int i = 0; i < kCuts; ++i) {
    monitor_.enter("sculpting", monitor_.share());
    if (!sculptor) sculptor.emplace(mesh_, evidence_, hold, limits.reaches_infinity);
    const std::vector<char> inside = sculptor->cut(monitor_.cancel());
    std::vector<char> sides(n, 0);  // [site]: 1 inside, 2 outside, 3 both: on the surface
    for (std::size_t t = 0; t < mesh_.size(); ++t)
      for (Index v : mesh_.tets.corners[t])
        if (v != kNone) sides[v] = static_cast<char>(sides[v] | (inside[t] ? 1 : 2));
    const std::size_t off = n - static_cast<std::size_t>(std::count(sides.begin(), sides.end(), 3));
    if (i == 0) cuts.missed = static_cast<double>(off) / static_cast<double>(n);
    if (off < first_off &&
        static_cast<double>(n - std::min(n, first_off)) < kKeptShare * static_cast<double>(n))
      cuts.first = inside, first_off = off;
    if (off < best_off) cuts.best = inside, best_off = off;
    const bool stalled =
        i > 0 && (2 * off < n) && (static_cast<double>(off) > kStalled * static_cast<double>(last_off));
    if (off == 0 || stalled) break;
    last_off = off;
    if (grown.empty()) grown = hold;
    const bool nothing = static_cast<double>(off) > kNothing * static_cast<double>(n);
    for (std::size_t t = 0; t < mesh_.size(); ++t)
      for (Index v : mesh_.tets.corners[t])
        if (v != kNone && sides[v] != 3) {
          const double before = grown[t];
          grown[t] *= nothing ? kFastGrowth : kConvictionGrowth;
          sculptor->hold_firmly(static_cast<Index>(t), before, grown[t]);
          break;
        }
  }
  // A cut that keeps fewer than half has lost the shape.
  cuts.has_shape = 2 * best_off <= n;
  return cuts;
}

Candidate Cutter::cut_field(std::vector<double> guess, bool open) {
  monitor_.enter("signed field", monitor_.share());
  return cut(signed_field(mesh_, evidence_, geometry_, std::move(guess), known_, monitor_.cancel()),
             kConviction, open);
}

// The belief: 1, surely inside, from 1 / kInsideSlope spacings below the width; -1, surely outside, from
// 1 / kCarveSlope above.
Candidate Cutter::cut_ball(double width, double conviction, bool open) {
  monitor_.enter("carving", monitor_.share());
  std::vector<double> belief = ball_widths(mesh_, sites_.perturbed, geometry_.spacing,
                                           width - 1 / kInsideSlope, width + 1 / kCarveSlope);
  for (double& b : belief) b = (width - b) * (b > width ? kCarveSlope : kInsideSlope);
  return cut(std::move(belief), conviction, open);
}

Candidate Cutter::cut_sides(const Vec3* viewpoint, bool open, const Candidate* rival) {
  monitor_.enter("two sides", monitor_.share());
  return cut(two_sides(mesh_, sites_.perturbed, evidence_, geometry_, viewpoint, monitor_.cancel()),
             kSidesConviction, open, {open, rival});
}

Candidate Cutter::refined(Candidate candidate) {
  for (int round = 0; round < kRefinements && !candidate.labels.empty(); ++round) {
    use_normals_of(candidate.surface);
    Candidate next = cut_field(belief_of(candidate.labels), candidate.open);
    if (!less(next, candidate) || next.quality.bridging > candidate.quality.bridging + kNewLid) break;
    candidate = std::move(next);
  }
  return candidate;
}

Candidate Cutter::moved(Candidate candidate, const std::function<bool(Labelling&)>& moves) {
  if (candidate.labels.empty()) return candidate;
  LabelCosts costs{evidence_.cost, std::move(candidate.hold), off_prices()};
  Labelling labelling(mesh_, geometry_, costs, candidate.labels, monitor_.cancel());
  repair(labelling, exempt(candidate.labels, candidate.open));  // takes the census
  const bool changed = moves(labelling);
  if (changed) settle(labelling, candidate);
  candidate.hold = std::move(costs.hold);
  return changed ? measured(std::move(candidate)) : candidate;
}

Candidate Cutter::plugged(Candidate candidate) {
  monitor_.enter("gaps", monitor_.share());
  return moved(std::move(candidate), [](Labelling& labelling) { return plug_gaps(labelling) > 0; });
}

Candidate Cutter::mended(Candidate candidate) {
  monitor_.enter("gaps", monitor_.share());
  return moved(std::move(candidate),
               [&](Labelling& labelling) { return mend(labelling, sites_.perturbed), true; });
}

Candidate Cutter::by_film(std::vector<char> labels, const UnsetVector<std::array<float, 4>>& prices) {
  monitor_.enter("manifold", monitor_.share());
  Candidate film;
  LabelCosts costs{prices, std::vector<double>(mesh_.size(), 0), off_prices()};
  Labelling labelling(mesh_, geometry_, costs, labels, monitor_.cancel());
  repair(labelling);
  settle(labelling, film);
  film.labels = std::move(labels);
  film.hold = std::move(costs.hold);
  return measured(std::move(film));
}

Candidate Cutter::warped(Candidate candidate, const std::vector<char>& aim) {
  monitor_.enter("manifold", monitor_.share());
  return moved(std::move(candidate), [&](Labelling& labelling) { return warp(labelling, aim), true; });
}

// Sites at which the labels need no manifold: an open surface must be one without its bridge faces only.
std::vector<char> Cutter::exempt(const std::vector<char>& labels, bool open) const {
  if (!open) return {};
  return manifold_without_bridges(tetrahedral_boundary(mesh_, labels), sites_.perturbed, geometry_);
}

Surface Cutter::surface_of(const std::vector<char>& labels, bool open) const {
  Surface surface = unsorted_surface_of_sites(tetrahedral_boundary(mesh_, labels), sites_.perturbed);
  if (open) remove_bridges(surface, geometry_);
  return surface;
}

Candidate Cutter::measured(Candidate candidate) const {
  candidate.quality = surface_quality(candidate.surface, geometry_);
  candidate.energy =
      surface_energy(candidate.quality, candidate.inserted, sites_.size()) +
      EnergyPrices().sight * blocked_lines(candidate.labels) / static_cast<double>(sites_.size());
  return candidate;
}

void Cutter::use_normals_of(const Surface& surface) {
  monitor_.enter("local evidence", monitor_.share());
  evidence_ = {};  // it is large
  SiteGeometry geometry = geometry_;
  geometry.normal = surface_normals(surface, std::move(geometry.normal));
  evidence_ = facet_evidence(mesh_, sites_.perturbed, geometry);
}

Candidate Cutter::around_one_tetrahedron() {
  monitor_.enter("manifold", monitor_.share());
  Candidate last;
  std::size_t fattest = 0;
  double most = 0;
  for (std::size_t t = 0; t < mesh_.size(); ++t) {
    if (mesh_.tets.infinite(static_cast<Index>(t))) continue;
    const auto& c = mesh_.tets.corners[t];
    const Vec3 a = sites_.exact(points_, c[0]), b = sites_.exact(points_, c[1]),
               d = sites_.exact(points_, c[2]), e = sites_.exact(points_, c[3]);
    const double volume = std::abs((b - a).cross(d - a).dot(e - a));
    if (volume > most) most = volume, fattest = t;
  }
  if (!(most > 0)) return last;
  last.labels.assign(mesh_.size(), 0);
  last.labels[fattest] = 1;
  LabelCosts costs{evidence_.cost, std::vector<double>(mesh_.size(), 0), off_prices()};
  costs.hold[fattest] = std::numeric_limits<double>::max();  // no move may remove it
  Labelling labelling(mesh_, geometry_, costs, last.labels);
  repair(labelling);  // takes the census; there is nothing to repair
  if (options_.insert_leftover) reach(labelling);
  last.inserted = labelling.counts.reached;
  last.surface = surface_of(last.labels, false);
  return last;
}

std::vector<double> belief_of(const std::vector<char>& labels) {
  std::vector<double> belief(labels.size());
  parallel_each(belief.size(), [&](std::size_t t) { belief[t] = labels[t] ? 1 : -1; });
  return belief;
}

}  // namespace filmsticking
