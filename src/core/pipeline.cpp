// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "delaunay/delaunay.h"
#include "evidence/ball.h"
#include "evidence/depth_image.h"
#include "evidence/signed_field.h"
#include "film/dense_film.h"
#include "film/film.h"
#include "film/initial_surface.h"
#include "film/stability.h"
#include "film/winding_number.h"
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
#include "surface/viewpoint.h"

namespace filmsticking {
namespace {

// Weight of a belief against the facets' evidence, per area.
constexpr double kConviction = 0.1;
// The same for the two sides of an open surface, which are known better: closing it costs the area of a lid.
constexpr double kSidesConviction = 1;
// Factor on the conviction around the sites that a cut missed. A weak conviction gives up thin plates; a
// strong one everywhere would not be smooth.
constexpr double kConvictionGrowth = 4;
// Most cuts by one belief.
constexpr int kCuts = 6;
// Fraction of sites that a cut keeps. The first cut above it decides the topology; later cuts only add sites.
constexpr double kKeptShare = 0.8;
// Fraction of missed sites that the next cut still misses. Above: stop.
constexpr double kStalled = 0.95;

// Of sites and handles: the same in Candidate::score(), in the cut and in the energy.
constexpr EnergyPrices kPrices;
// Price per fraction of area in bridge faces, where 1 is the price of normals that disagree everywhere.
constexpr double kBridgePrice = 0.5;
// Price per fraction of near sites with opposite normals.
constexpr double kOppositePrice = 0.1;

// Carvings, in this order. Width: the ball that carves the outside does not enter narrower places, in
// spacings. Conviction: see above; a weak one gives up shapes whose walls are thin nearly everywhere. Share:
// accept below this fraction of the best score. The last width is that of some chance gaps.
constexpr struct {
  double width, conviction, share = 1;
} kCarvings[] = {{2, kConviction}, {4, kConviction}, {2, 0.5}, {2.5, 0.5}, {1.5, 0.5, 0.9}};
// Growth of the belief in the outside per spacing of width. Slow: the evidence decides about chance gaps in
// thin walls.
constexpr double kCarveSlope = 0.2;
// Growth of the belief in the inside per spacing.
constexpr double kInsideSlope = 3;
// Most cuts by evidence from the surface's own normals. Later ones change little.
constexpr int kRefinements = 2;
// Fraction of sites that such a cut may lose. More: reject.
constexpr double kGivenUp = 0.001;

// Ball of the alpha wrap, in longest sides of the box.
constexpr double kWrapAlpha = 0.05;
// Tetrahedra per site. More: the points are on no surface, but on two curves, say; no virtual sites or
// weights.
constexpr std::int64_t kMostForFilm = 64;
// Width of the narrowest place through which dense virtual sites lead a film, in spacings. Virtual sites keep
// twice the spacing from all points (virtual_sites.h).
constexpr double kFilmWidth = 2;
// Fraction of sites that a film must reach. Fewer: its start leaked or ran past the points; try the next one.
constexpr double kReached = 0.5;

// Fraction of sites missed by the first cut. < 1 %: accept.
constexpr double kLittleTrouble = 0.01;
// > 10 %: also try open-surface methods.
constexpr double kSomeTrouble = 0.1;
// > 30 %: assume there is no inside.
constexpr double kNoInside = 0.3;
// Fraction of sites off the best surface. > 10 %: also try the film from the sphere.
constexpr double kMuchTrouble = 0.1;
// Score of two sides over that of the first surface, which may have an inside. < 0.9: two sides are better.
constexpr double kMuchBetter = 0.9;

// Price in open_surface_score() per fraction of near sites with opposite normals.
constexpr double kConflictPrice = 2;
// Price in open_surface_score() of a handle, in sites off the surface.
constexpr double kHandlePrice = 20;
// open_surface_score() by which a view may be worse than another surface and is still preferred.
constexpr double kLoose = 0.005;
// Fraction of sites by which a view may have more off than another surface.
constexpr double kFewMissed = 0.001;
// Fraction of the lines of sight that cross the other surface an odd number of times. < 0.4: it is closed, so
// the view is not the better one.
constexpr double kSeenOpen = 0.4;
// Disagreement (SurfaceQuality) of a view. > 0.15: it may run through both sides of a plate 0.4 spacings
// thick.
constexpr double kThinnest = 0.15;
// closed_surface_score() of a closed view over that of the best closed surface. < 0.5: take the view.
constexpr double kMuchPlainer = 0.5;

// Handles of an open surface. > 3: it may be a thin wall, torn; try a closed surface.
constexpr std::int64_t kWhole = 3;
// Handles of the open surface over components and handles of the closed one. >= 4: it was torn.
constexpr std::int64_t kTorn = 4;
// Score of the closed surface over that of the open one. < 0.5: it was torn. Measured: 0.33 for plates half a
// spacing thick, 0.77 for noise.
constexpr double kFarBetter = 0.5;

// Rules for facets at the rim of an open surface: votes, weight. Chance and noise decide which is best; where
// neighbours disagree, the best of the three is taken.
constexpr RimRule kFirstRim{3, 0.03}, kSecondRim{2, 0.03}, kThirdRim{3, 0.3};
// Fraction of near sites with opposite normals. <= 0.5 %: neighbours agree; try no other rule.
constexpr double kLittleConflict = 0.005;
// Price per fraction of area that faces away from the viewpoint.
constexpr double kTurnedPrice = 0.5;

// Components and handles per site. > 1.5 %: two sides confuse the layers of thin walls.
constexpr double kMostComplex = 0.015;

// Two sides are a plain open surface if all of these hold.
// Fraction of sites missed by their first cut: <= 2 %.
constexpr double kPlainMissed = 0.02;
// Components and handles per site: <= 1 %.
constexpr double kPlainComplex = 0.01;
// Fraction of near sites with opposite normals, over that of the first surface, where there is no inside: <
// 0.75; where there may be one: < 0.25.
constexpr double kPlainConflict = 0.75, kFarLessConflict = 0.25;
// Fraction of area in bridge faces, if the result is to be closed: > 20 %, the lid.
constexpr double kLid = 0.2;

// The prices of facets by which the farther region of a site gives way (RingChoice::Nearest): a region is as
// far from its site as the dual edge, which joins the centres of the facet's two balls.
UnsetVector<std::array<float, 4>> prices_by_distance(const TetrahedralMesh& mesh,
                                                     const FacetEvidence& evidence) {
  UnsetVector<std::array<float, 4>> prices(mesh.size());
  parallel_each(mesh.size(), [&](std::size_t t) {
    for (int k = 0; k < 4; ++k) {
      const auto u = static_cast<std::size_t>(mesh.tets.neighbours[t][k]);
      const double nearest = std::min(mesh.circumradius[t], mesh.circumradius[u]);
      prices[t][k] =
          std::isfinite(nearest) ? static_cast<float>(evidence.area[t][k] * nearest) : evidence.cost[t][k];
    }
  });
  return prices;
}

}  // namespace

Pipeline::Pipeline(const PointsView& points, const SiteSet& sites, const SiteGeometry& geometry,
                   const Options& options, Monitor& monitor, Report& report)
    : points_(points),
      sites_(sites),
      geometry_(geometry),
      options_(options),
      monitor_(monitor),
      report_(report),
      open_(options.open_boundary) {}

double Pipeline::Candidate::score() const {
  if (surface.triangles.empty()) return std::numeric_limits<double>::infinity();
  const double sites = static_cast<double>(surface.site.size()) + static_cast<double>(quality.off);
  return quality.disagreement + kOppositePrice * quality.conflict + kBridgePrice * quality.bridging +
         (static_cast<double>(quality.off) + kPrices.inserted * static_cast<double>(inserted) +
          kPrices.complexity * static_cast<double>(quality.complexity)) /
             sites;
}

// Faces may be rough, so their disagreement does not count. Lower is better.
double Pipeline::open_surface_score(const SurfaceQuality& quality) const {
  return kConflictPrice * quality.conflict +
         (static_cast<double>(quality.off) + kHandlePrice * static_cast<double>(quality.handles)) /
             static_cast<double>(sites_.size());
}

// Lower is better.
double Pipeline::closed_surface_score(const SurfaceQuality& quality) const {
  return (static_cast<double>(quality.off) + kHandlePrice * static_cast<double>(quality.complexity)) /
         static_cast<double>(sites_.size());
}

// Returns the belief that the signed field starts from: the film's.
std::vector<double> Pipeline::prepare(Tetrahedra tetrahedra) {
  report_.tetrahedra = static_cast<std::int64_t>(tetrahedra.size());
  mesh_ = make_tetrahedral_mesh(std::move(tetrahedra), sites_.perturbed);
  monitor_.enter("local evidence", 0.15);
  evidence_ = facet_evidence(mesh_, sites_.perturbed, geometry_);
  if (method_of(options_) != Method::Labelling) return {};
  return belief_of(film_from_sphere());
}

void Pipeline::show(const Surface& surface) const {
  if (!monitor_.execution().on_step) return;
  Mesh mesh;
  for (const Vec3& p : surface.positions) mesh.positions.push_back(sites_.to_input(p));
  mesh.triangles.assign(surface.triangles.begin(), surface.triangles.end());
  call_back([&] { monitor_.execution().on_step(static_cast<int>(report_.steps.size()), mesh); });
}

// With dense virtual sites. Its steps are recorded where the caller watches them; else they are not made one
// by one.
std::vector<char> Pipeline::film_from_sphere() {
  monitor_.enter("film", monitor_.share());
  std::function<void(const std::vector<char>&)> after_step;
  if (monitor_.execution().on_step) {
    show(bounding_sphere(sites_.perturbed));
    after_step = [&](const std::vector<char>& inside) {
      const Surface film = film_surface(mesh_.tets, inside, sites_.perturbed);
      StepRecord record;
      std::vector<char> on(sites_.size(), 0);
      for (const Index s : film.site) on[s] = 1;
      record.attracted = std::count(on.begin(), on.end(), 1);
      report_.steps.push_back(record);
      show(film);
    };
  }
  return dense_film(mesh_, sites_.perturbed, geometry_.spacing, kFilmWidth, after_step);
}

std::vector<double> Pipeline::off_prices() const {
  std::vector<double> prices(sites_.size());
  parallel_each(prices.size(), [&](std::size_t v) {
    const double spacing = std::min(geometry_.spacing[v], near_spacing(geometry_, static_cast<Index>(v)));
    prices[v] = kPrices.off * spacing * spacing;
  });
  return prices;
}

// What a label against a belief costs, per tetrahedron.
std::vector<double> Pipeline::held(std::vector<double> belief, double conviction) const {
  parallel_each(belief.size(), [&](std::size_t t) {
    const auto& area = evidence_.area[t];
    belief[t] *= conviction * (double{area[0]} + area[1] + area[2] + area[3]);
  });
  return belief;
}

// Cuts by a belief: labels of several cuts, made manifold. The first cut that keeps most sites decides the
// topology; the cut with most sites is what the moves aim at. `reaches_infinity`: the inside may.
Pipeline::Candidate Pipeline::cut(const std::vector<double>& belief, double conviction, bool open,
                                  bool reaches_infinity) {
  LabelCosts costs{evidence_.cost, held(belief, conviction), off_prices()};
  Candidate candidate;
  candidate.open = open;
  Cuts cuts = several_cuts(costs.hold, reaches_infinity);
  candidate.missed = cuts.missed;
  if (!cuts.has_shape) return candidate;

  monitor_.enter("manifold", monitor_.share());
  std::vector<char>& labels = cuts.first;
  Labelling labelling(mesh_, geometry_, costs, labels, monitor_.cancel());
  repair(labelling, exempt(labels, open));
  warp(labelling, cuts.best);
  unfold(labelling);
  if (options_.insert_leftover) reach(labelling);
  candidate.inserted = labelling.counts.reached;
  candidate.surface = surface_of(labels, open);
  candidate.labels = std::move(labels);
  candidate.hold = std::move(costs.hold);
  return candidate;
}

// Conviction grows around the sites that the cut before missed.
Pipeline::Cuts Pipeline::several_cuts(const std::vector<double>& hold, bool reaches_infinity) {
  const std::size_t n = sites_.size();
  Cuts cuts;
  std::optional<Sculptor> sculptor;
  std::vector<double> grown;  // instead of `hold`, if there is a second cut
  std::size_t first_off = n + 1, best_off = n + 1, last_off = n;
  for (int i = 0; i < kCuts; ++i) {
    monitor_.enter("sculpting", monitor_.share());
    if (!sculptor) sculptor.emplace(mesh_, evidence_, hold, reaches_infinity);
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
    for (std::size_t t = 0; t < mesh_.size(); ++t)
      for (Index v : mesh_.tets.corners[t])
        if (v != kNone && sides[v] != 3) {
          const double before = grown[t];
          grown[t] *= kConvictionGrowth;
          sculptor->hold_firmly(static_cast<Index>(t), before, grown[t]);
          break;
        }
  }
  // A cut that keeps fewer than half has lost the shape.
  cuts.has_shape = 2 * best_off <= n;
  return cuts;
}

// Sites at which the labels need no manifold: an open surface must be one without its bridge faces only.
std::vector<char> Pipeline::exempt(const std::vector<char>& labels, bool open) const {
  if (!open) return {};
  return manifold_without_bridges(tetrahedral_boundary(mesh_, labels), sites_.perturbed, geometry_);
}

Surface Pipeline::surface_of(const std::vector<char>& labels, bool open) const {
  Surface surface = unsorted_surface_of_sites(tetrahedral_boundary(mesh_, labels), sites_.perturbed);
  if (open) remove_bridges(surface, geometry_);
  return surface;
}

// Moves that close chance gaps and open cavities. For the candidate that was chosen, since handles reveal a
// bad one; or for copies of two, to compare them. The result has no `hold`.
Pipeline::Candidate Pipeline::mended(Candidate candidate, Mend mend) {
  if (candidate.labels.empty()) return candidate;
  monitor_.enter("gaps", monitor_.share());
  const LabelCosts costs{evidence_.cost, std::move(candidate.hold), off_prices()};
  Labelling labelling(mesh_, geometry_, costs, candidate.labels, monitor_.cancel());
  repair(labelling, exempt(candidate.labels, candidate.open));  // takes the census
  if (mend == Mend::Plugs) {
    mend_plugs(labelling);
    if (labelling.counts.tunnels + labelling.counts.tears == 0) return candidate;
  } else {
    filmsticking::mend(labelling, sites_.perturbed);
  }
  unfold(labelling);
  if (options_.insert_leftover) reach(labelling);
  candidate.inserted += labelling.counts.reached;
  candidate.surface = surface_of(candidate.labels, candidate.open);
  return measured(std::move(candidate));
}

Pipeline::Candidate Pipeline::measured(Candidate candidate) const {
  candidate.quality = surface_quality(candidate.surface, geometry_);
  return candidate;
}

// 1, surely inside, from 1 / kInsideSlope spacings below the limit; -1, surely outside, from 1 / slope above.
std::vector<double> Pipeline::ball_belief(double limit, double slope) const {
  std::vector<double> belief =
      ball_widths(mesh_, sites_.perturbed, geometry_.spacing, limit - 1 / kInsideSlope, limit + 1 / slope);
  for (double& b : belief) b = (limit - b) * (b > limit ? slope : kInsideSlope);
  return belief;
}

std::vector<double> Pipeline::winding_belief(const Surface& film) const {
  const WindingNumber winding(sites_.perturbed, film_dipoles(film, geometry_.spacing));
  std::vector<double> belief(mesh_.size(), -1);
  parallel_each(mesh_.size(), [&](std::size_t t) {
    if (mesh_.tets.infinite(static_cast<Index>(t))) return;
    Vec3 centre = Vec3::Zero();
    for (Index i : mesh_.tets.corners[t]) centre += sites_.perturbed[i] / 4;
    belief[t] = std::clamp(2 * winding(centre) - 1, -1.0, 1.0);
  });
  return belief;
}

// Cuts by what the film says of inside and outside (paper, section 5): its normals decide the votes, and its
// winding number or Poisson's equation on the tetrahedra the belief.
Pipeline::Candidate Pipeline::without_dangling(const Candidate& film) {
  use_normals_of(film.surface);
  monitor_.enter("field", monitor_.share());
  std::vector<double> belief;
  if (options_.field == FieldMethod::Poisson) {
    belief = signed_field(mesh_, evidence_, belief_of(film.labels), monitor_.cancel());
  } else {
    belief = winding_belief(film.surface);
  }
  return measured(cut(belief, kConviction, open_));
}

// Evidence by the surface's own normals.
void Pipeline::use_normals_of(const Surface& surface) {
  monitor_.enter("local evidence", monitor_.share());
  evidence_ = {};  // it is large
  SiteGeometry geometry = geometry_;
  geometry.normal = surface_normals(surface, std::move(geometry.normal));
  evidence_ = facet_evidence(mesh_, sites_.perturbed, geometry);
}

std::vector<double> Pipeline::belief_of(const std::vector<char>& labels) const {
  std::vector<double> belief(labels.size());
  parallel_each(belief.size(), [&](std::size_t t) { belief[t] = labels[t] ? 1 : -1; });
  return belief;
}

Surface Pipeline::around_one_tetrahedron() {
  monitor_.enter("manifold", monitor_.share());
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
  if (!(most > 0)) return {};
  std::vector<char> labels(mesh_.size(), 0);
  labels[fattest] = 1;
  LabelCosts costs{evidence_.cost, std::vector<double>(mesh_.size(), 0), off_prices()};
  costs.hold[fattest] = std::numeric_limits<double>::max();  // no move may remove it
  Labelling labelling(mesh_, geometry_, costs, labels);
  repair(labelling);  // takes the census; there is nothing to repair
  if (options_.insert_leftover) reach(labelling);
  report_.inserted = labelling.counts.reached;
  return unsorted_surface_of_sites(tetrahedral_boundary(mesh_, labels), sites_.perturbed);
}

// Is there nothing to remove and nothing to correct?
bool Pipeline::needs_no_round(const Candidate& candidate) {
  return candidate.inserted == 0 && candidate.quality.off == 0 && candidate.quality.wide_faces == 0;
}

// Cuts again by evidence from the surface's own normals: they are better than those of neighbourhoods, which
// reach across thin walls and edges. Accepts the next surface only if its score by the fitted normals is
// better, it loses hardly any sites, and it is no more complex, with the gaps of both filled: a new handle
// may be a leak.
Pipeline::Candidate Pipeline::refined(Candidate best) {
  for (int round = 0; round < kRefinements && !best.labels.empty(); ++round) {
    use_normals_of(best.surface);
    monitor_.enter("signed field", monitor_.share());
    Candidate next = measured(cut(signed_field(mesh_, evidence_, belief_of(best.labels), monitor_.cancel()),
                                  kConviction, best.open));
    const double given_up = static_cast<double>(next.quality.off - best.quality.off);
    if (!(next.score() < best.score()) || given_up > kGivenUp * static_cast<double>(sites_.size())) break;
    // A chance gap is no leak, so gaps are filled before the comparison; in copies, because a surface with
    // filled gaps would keep the errors beside them in the next cut.
    if (next.quality.complexity > best.quality.complexity) {
      const std::int64_t filled = mended(next).quality.complexity;
      if (filled > 1 && filled > mended(best).quality.complexity) break;
    }
    best = std::move(next);
  }
  return best;
}

Pipeline::Candidate Pipeline::cut_sides(const RimRule& rim, const Vec3* viewpoint, bool open,
                                        bool reaches_infinity) {
  monitor_.enter("two sides", monitor_.share());
  return measured(
      cut(two_sides(mesh_, sites_.perturbed, evidence_, geometry_, rim, viewpoint, monitor_.cancel()),
          kSidesConviction, open, reaches_infinity));
}

// By the facets alone. Where neighbours on an open surface disagree, tries the other rules; the last one with
// the viewpoint of the best surface, if that is a scan from one side.
Pipeline::Candidate Pipeline::cut_two_sides() {
  const auto by_rule = [&](const RimRule& rim, const Vec3* viewpoint) {
    return cut_sides(rim, viewpoint, open_, open_);
  };
  Candidate best = by_rule(kFirstRim, nullptr);
  if (!open_ || best.quality.conflict <= kLittleConflict) return best;
  Candidate next = by_rule(kSecondRim, nullptr);
  if (next.score() < best.score()) best = std::move(next);
  if (best.quality.conflict <= kLittleConflict) return best;
  monitor_.enter("two sides", monitor_.share());
  const Vec3 viewpoint = common_viewpoint(best.surface);
  const bool one_view =
      !best.surface.triangles.empty() && is_seen_once(best.surface, viewpoint, monitor_.cancel());
  next = by_rule(kThirdRim, one_view ? &viewpoint : nullptr);
  const auto price = [&](const Candidate& sides) {
    return sides.score() + (one_view ? kTurnedPrice * turned_away_share(sides.surface, viewpoint) : 0);
  };
  return price(next) < price(best) ? std::move(next) : std::move(best);
}

std::optional<Vec3> Pipeline::given_viewpoint() const {
  if (!options_.viewpoint) return {};
  return sites_.to_unit(*options_.viewpoint);
}

std::vector<Vec3> Pipeline::exact_places() const {
  std::vector<Vec3> places(sites_.size());
  parallel_each(places.size(), [&](std::size_t s) { places[s] = sites_.exact(points_, s); });
  return places;
}

std::optional<DepthImage> Pipeline::image_of(const std::vector<Vec3>& places) {
  monitor_.enter("depth image", monitor_.share());
  return depth_image(places, geometry_, given_viewpoint(), monitor_.cancel());
}

std::optional<FoundSurface> Pipeline::visible_surface() {
  std::optional<DepthImage> image = image_of(exact_places());
  if (!image) return {};
  return FoundSurface{std::move(image->surface), image->viewpoint, {}};
}

// All sites, seen from the viewpoint that the caller gives; nothing if they cannot be. For depth images that
// are thinned or rough, which do not look like one by their pixels.
std::optional<DepthImage> Pipeline::given_view() {
  const std::optional<Vec3> viewpoint = given_viewpoint();
  if (!viewpoint) return {};
  monitor_.enter("depth image", monitor_.share());
  return image_from(exact_places(), *viewpoint, geometry_, monitor_.cancel());
}

// Compares the view with the surface found without it. The view is better if the other surface is open as
// seen from there and the view has about as few folds, handles and missed sites. Ties go to the view, which
// knows the side that is seen.
bool Pipeline::is_better_view(const DepthImage& image, Surface found) const {
  Candidate open;
  open.surface = std::move(found);
  remove_bridges(open.surface, geometry_);
  if (odd_crossing_share(open.surface, image.viewpoint, monitor_.cancel()) < kSeenOpen) return false;
  const SurfaceQuality other = measured(std::move(open)).quality;
  const double off = static_cast<double>(std::max<std::int64_t>(0, image.quality.off - other.off));
  return off <= kFewMissed * static_cast<double>(sites_.size()) &&
         open_surface_score(image.quality) < open_surface_score(other) + kLoose;
}

// Inside is what is behind a depth image. Its gaps are those of its steps in depth.
Pipeline::Candidate Pipeline::cut_image(const Vec3& viewpoint) {
  const std::vector<double> sides = depth_image_sides(mesh_, sites_.perturbed, viewpoint, monitor_.cancel());
  return mended(measured(cut(sides, kConviction, open_)), Mend::Plugs);
}

// Method::Labelling. First by local evidence alone; if that cut misses many sites, by other starts too. A
// depth image is tried before them, since it knows more. `guess`: the belief that the field starts from.
Pipeline::Candidate Pipeline::labelling(std::vector<double> guess) {
  monitor_.enter("signed field", 0.25);
  Candidate best =
      cut(signed_field(mesh_, evidence_, std::move(guess), monitor_.cancel()), kConviction, open_);
  best = measured(std::move(best));
  if (best.missed <= kLittleTrouble && !best.surface.triangles.empty()) {
    // With a handle or a second component it may have walls, if no thin ones.
    if (best.quality.complexity > 1) best = mended(std::move(best), Mend::Plugs);
    return best;
  }
  return open_ ? beyond_first(std::move(best)) : or_solid(best, beyond_first(best));
}

// The first surface, mended, where it has an inside and its energy is the lower. Noise gives a shell two
// skins of samples, which others tear apart; the first is the solid, with a lid over its opening.
Pipeline::Candidate Pipeline::or_solid(Candidate first, Candidate found) {
  const auto energy = [&](const Candidate& candidate) {
    return surface_energy(candidate.quality, candidate.inserted, sites_.size());
  };
  if (!has_shape(first) || !(energy(first) < energy(found))) return found;
  use_normals_of(first.surface);
  return mended(std::move(first));
}

// Where the first cut misses many sites, by local evidence alone: tries other starts too.
Pipeline::Candidate Pipeline::beyond_first(Candidate best) {
  if (best.missed <= kSomeTrouble) return carve_further(std::move(best), false);

  if (!open_)
    if (const auto image = image_of(sites_.perturbed))
      if (Candidate closed = cut_image(image->viewpoint); has_shape(closed)) return closed;
  const std::optional<DepthImage> view = given_view();
  Candidate sides = cut_two_sides();
  const auto by_view = [&] {
    if (!open_) return cut_image(view->viewpoint);
    Candidate seen;
    seen.surface = view->surface;
    seen.viewpoint = view->viewpoint;
    return seen;
  };
  if (view && view->quality.disagreement <= kThinnest) {
    // Not a closed surface: it could follow both sides of an open one, which says nothing.
    Surface found = open_ ? (sides.score() < best.score() ? sides : best).surface
                          : cut_sides(kFirstRim, nullptr, false, true).surface;
    if (is_better_view(*view, std::move(found)))
      if (Candidate seen = by_view(); open_ || has_shape(seen)) return seen;
  }
  // A rough view may still be that of a thin wall, but a thin wall gives a plain closed surface.
  if (open_) {
    Candidate first = best;
    best = closed_if_torn(with_sides(std::move(best), std::move(sides)), std::move(first));
    return view && is_better_view(*view, best.surface) ? by_view() : std::move(best);
  }
  best = with_sides(std::move(best), std::move(sides));
  if (!view) return best;
  Candidate seen = by_view();
  const bool plainer = closed_surface_score(seen.quality) < kMuchPlainer * closed_surface_score(best.quality);
  return has_shape(seen) && plainer ? std::move(seen) : std::move(best);
}

// An open surface with many handles may be a thin wall, torn. `closed`: the first candidate, from which
// carving starts. The closed surface is taken if its score is far better, it has hardly a handle and no more
// sites are off.
Pipeline::Candidate Pipeline::closed_if_torn(Candidate open, Candidate closed) {
  if (open.quality.handles <= kWhole) return open;
  closed.open = false;
  if (!closed.labels.empty())
    closed.surface = surface_of(closed.labels, false), closed = measured(std::move(closed));
  bool two_sided = false;
  closed = by_widths(std::move(closed), two_sided);
  if (closed.score() < open.score()) closed = mended(refined(std::move(closed)));
  const bool whole = closed.score() < kFarBetter * open.score() && closed.quality.off <= open.quality.off &&
                     kTorn * closed.quality.complexity <= open.quality.handles;
  return whole ? std::move(closed) : std::move(open);
}

bool Pipeline::has_shape(const Candidate& candidate) {
  return !candidate.surface.triangles.empty() && candidate.missed <= kNoInside;
}

// Returns `sides` if they are a plain open surface; else the better of both, carved further.
Pipeline::Candidate Pipeline::with_sides(Candidate best, Candidate sides) {
  const double complexity =
      static_cast<double>(sides.quality.complexity) / static_cast<double>(sites_.size());
  // Nothing is better than a plain open surface, and carving one takes long. Its closed form has a lid of
  // bridge faces, so its score is bad; a thin closed surface has none, but its normals oppose each other.
  const bool no_inside = best.missed > kNoInside;
  const bool better = sides.score() < (no_inside ? 1 : kMuchBetter) * best.score();
  const bool best_open = open_ && sides.missed <= kLittleTrouble && complexity <= kLittleTrouble && better;
  const bool open = open_ ? sides.score() < best.score() : sides.quality.bridging > kLid;
  const bool plain =
      open && sides.missed <= kPlainMissed && complexity <= kPlainComplex &&
      sides.quality.conflict < (no_inside ? kPlainConflict : kFarLessConflict) * best.quality.conflict;
  if (best_open || plain) return open_ ? std::move(sides) : mended(std::move(sides));
  const bool two_sided = complexity <= kMostComplex && better;
  return carve_further(two_sided ? std::move(sides) : std::move(best), two_sided);
}

// Carves at several widths and convictions, and keeps the best. `two_sided`: `best` is that of two sides;
// false once a carving is better.
Pipeline::Candidate Pipeline::by_widths(Candidate best, bool& two_sided) {
  for (const auto& carving : kCarvings) {
    // Measured: no better than two sides for slabs and shells, and as slow as the others together.
    if (two_sided && carving.conviction > kConviction) continue;
    monitor_.enter("carving", monitor_.share());
    Candidate other = measured(cut(ball_belief(carving.width, kCarveSlope), carving.conviction, best.open));
    if (other.score() < carving.share * best.score()) best = std::move(other), two_sided = false;
  }
  return best;
}

// Carves, then cuts the best again by its own normals. If many sites are still off, because inside and
// outside cannot be distinguished, also tries the film from the sphere.
Pipeline::Candidate Pipeline::carve_further(Candidate best, bool two_sided) {
  best = by_widths(std::move(best), two_sided);
  if (!two_sided) best = refined(std::move(best));
  best = mended(std::move(best));
  const auto enough = static_cast<std::int64_t>(kMuchTrouble * static_cast<double>(sites_.size()));
  if (!best.surface.triangles.empty() && best.quality.off <= enough) return best;
  Candidate film = film_from_outside();
  if (film.score() < best.score()) best = std::move(film);
  return best;
}

// The surfaces that a film starts from, in the order in which they are tried. A wrap finer than the gaps
// between the points leaks through them; a coarser one or the sphere does not.
std::vector<std::function<Surface()>> Pipeline::first_films() const {
  const auto sphere = [this] { return bounding_sphere(sites_.perturbed); };
  const auto wrap = [this](double alpha) {
    return [this, alpha] { return alpha_wrap(sites_.perturbed, alpha); };
  };
  const auto given = [this] {
    Surface surface;
    for (const Point& p : options_.guiding_surface->positions) surface.positions.push_back(sites_.to_unit(p));
    surface.site.assign(surface.positions.size(), kNone);
    surface.triangles.assign(options_.guiding_surface->triangles.begin(),
                             options_.guiding_surface->triangles.end());
    return surface;
  };
  switch (film_start_of(options_)) {
    case FilmStart::Wrap:
      return {wrap(kWrapAlpha), wrap(2 * kWrapAlpha), wrap(4 * kWrapAlpha), sphere};
    case FilmStart::Given:
      return {given};
    default:
      return {sphere};
  }
}

FilmOptions Pipeline::film_options() {
  FilmOptions options;
  const bool usual = report_.tetrahedra <= kMostForFilm * report_.sites;
  options.virtual_sites = usual ? options_.virtual_sites : 0;
  options.weights = usual && options_.weights;
  options.memory = options_.ring == RingChoice::Smooth;
  options.max_steps = options_.max_steps;
  options.round = report_.rounds;
  options.limits.cancel = monitor_.cancel();
  options.after_step = [&](const StepRecord& record, const LabelledFilm& film) {
    report_.steps.push_back(record);
    // The number of steps is unknown: each counts as a twentieth of what is left.
    monitor_.progress(monitor_.share() + (0.95 - monitor_.share()) * 0.05);
    if (monitor_.execution().on_step) show(film_surface(film, sites_.size()));
  };
  return options;
}

// Evolves a film from the first start from which it reaches the points.
Pipeline::Candidate Pipeline::film_from_outside() {
  Candidate film;
  for (const auto& first : first_films()) {
    monitor_.enter("first surface", 0.2);
    const Surface start = first();
    monitor_.enter("film", monitor_.share());
    if (report_.steps.empty()) show(start);
    film = manifold_film(
        evolve_film(enclosure(start), mesh_, sites_.perturbed, geometry_.spacing, film_options()));
    if (static_cast<double>(film.quality.off) < kReached * static_cast<double>(sites_.size())) break;
  }
  return film;
}

// Where a site is singular, the dearer side gives way. Then takes the sites in that are near.
Pipeline::Candidate Pipeline::manifold_film(std::vector<char> labels) {
  monitor_.enter("manifold", monitor_.share());
  Candidate film;
  UnsetVector<std::array<float, 4>> by_distance;
  if (options_.ring == RingChoice::Nearest) by_distance = prices_by_distance(mesh_, evidence_);
  const LabelCosts costs{options_.ring == RingChoice::Nearest ? by_distance : evidence_.cost,
                         std::vector<double>(mesh_.size(), 0), off_prices()};
  Labelling labelling(mesh_, geometry_, costs, labels, monitor_.cancel());
  repair(labelling);
  unfold(labelling);
  if (options_.insert_leftover) reach(labelling);
  film.inserted = labelling.counts.reached;
  film.surface = surface_of(labels, false);
  film.labels = std::move(labels);
  film.hold = costs.hold;
  return measured(std::move(film));
}

// The paper's last step: one film step from the surface that the field gave. It moves the surface as far as
// its topology, which the field decided, allows.
Pipeline::Candidate Pipeline::after_last_step(Candidate candidate) {
  if (candidate.labels.empty()) return candidate;
  monitor_.enter("film", monitor_.share());
  FilmOptions options = film_options();
  options.weights = false, options.max_steps = 2;
  const std::vector<char> aim =
      evolve_film(candidate.labels, mesh_, sites_.perturbed, geometry_.spacing, options);
  monitor_.enter("manifold", monitor_.share());
  const LabelCosts costs{evidence_.cost, std::move(candidate.hold), off_prices()};
  Labelling labelling(mesh_, geometry_, costs, candidate.labels, monitor_.cancel());
  repair(labelling, exempt(candidate.labels, candidate.open));  // takes the census
  warp(labelling, aim);
  unfold(labelling);
  if (options_.insert_leftover) reach(labelling);
  candidate.inserted += labelling.counts.reached;
  candidate.hold = costs.hold;
  candidate.surface = surface_of(candidate.labels, candidate.open);
  return measured(std::move(candidate));
}

// Rounds of field, cut and film.
void Pipeline::rounds(Candidate& best) {
  if (options_.field == FieldMethod::None || best.surface.triangles.empty()) return;
  for (int round = 0; round < options_.max_rounds && !needs_no_round(best); ++round) {
    ++report_.rounds;
    monitor_.progress(0.5 + 0.45 * round / options_.max_rounds);
    Candidate next = after_last_step(without_dangling(best));
    if (!(next.score() < best.score())) break;
    best = std::move(next);
  }
}

FoundSurface Pipeline::run(Tetrahedra tetrahedra) {
  std::vector<double> guess = prepare(std::move(tetrahedra));
  Candidate best;
  if (method_of(options_) == Method::Labelling) {
    best = labelling(std::move(guess));
    show(best.surface);
  } else {
    best = film_from_outside();
    rounds(best);
  }
  report_.inserted = best.inserted;
  std::vector<float> stability;
  if (options_.stability && !best.labels.empty()) {
    monitor_.enter("stability", monitor_.share());
    stability = site_stability(mesh_, sites_.perturbed, best.labels);
  }
  return {std::move(best.surface), best.viewpoint, std::move(stability)};
}

}  // namespace filmsticking
