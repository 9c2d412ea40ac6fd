// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline.h"

#include <tbb/parallel_invoke.h>

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
#include "film/film.h"
#include "film/initial_surface.h"
#include "film/insert_sites.h"
#include "film/poisson.h"
#include "film/virtual_sites.h"
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
#include "surface/open_surface.h"
#include "surface/surface_normals.h"
#include "surface/viewpoint.h"

namespace filmsticking {
namespace {

// A belief is weighed against the evidence with this conviction; it grows around sites that the cut leaves
// off, a few times: thin plates are given up by a weak one, and a strong one everywhere would not be smooth.
constexpr double kConviction = 0.1, kConvictionGrowth = 4;
// The two sides of an open surface are known better, but closing it costs the area of the gap.
constexpr double kSidesConviction = 1;
constexpr int kCuts = 6;
// The first cut that keeps this share of the sites has the shape; later ones only bring sites.
constexpr double kKeptShare = 0.8;
// A cut that leaves this share off as the one before is the last.
constexpr double kStalled = 0.95;
// What a component or a handle costs a candidate, in sites off it.
constexpr double kComplexityPrice = 5;
// What a surface all of bridges would cost, beside one whose normals disagree everywhere.
constexpr double kBridgePrice = 0.5;
// What a site off the surface costs, in areas of one sample.
constexpr double kOffPrice = 5;
// Widths up to which carving does not enter, in spacings, and the conviction with which it is believed then;
// and how much surer it is of the outside for a width one spacing larger. The slow rise leaves chance gaps in
// a thin wall to the evidence. Where walls are thin nearly everywhere, a weak conviction gives them up. The
// last width is that of some chance gaps: its score must be this share of the best one.
constexpr struct {
  double width, conviction, share = 1;
} kCarvings[] = {{2, kConviction}, {4, kConviction}, {2, 0.5}, {2.5, 0.5}, {1.5, 0.5, 0.9}};
constexpr double kCarveSlope = 0.2;
// How much surer of the inside for a width one spacing smaller.
constexpr double kInsideSlope = 3;
// How many times a surface may be cut again, by evidence from its own normals: later times change little.
constexpr int kRefinements = 2;
// More sites than this share of all may not be given up for it.
constexpr double kGivenUp = 0.001;
// A wrap's ball in units of the box's longest side.
constexpr double kWrapAlpha = 0.05;
// An inserted site may be this many longest edges of its face away from it.
constexpr double kReach = 2;

// Shares of the sites: a first cut that leaves no more off than the first is taken; one that leaves more off
// than the second may be that of an open surface, and more than the third, has no inside; where the best
// surface leaves more off than the last, the film from the sphere is tried too.
constexpr double kLittleTrouble = 0.01, kSomeTrouble = 0.1, kNoInside = 0.3, kMuchTrouble = 0.1;
// Of the first surface's score, that of two sides must be less than this share where there may be an inside.
constexpr double kMuchBetter = 0.9;

// Tetrahedra a site above which the points are on no surface, but on two curves, say.
constexpr std::int64_t kMostForVirtual = 64;

// What a surface costs of which all neighbours face opposite ways, and what a handle of an open surface
// costs, in sites off it. What costs no more than that above another is as good, if it leaves no more sites
// off than that share. Seen from where it was seen from, a surface is open where no fewer lines cross it
// oddly.
constexpr double kConflictPrice = 2, kHandlePrice = 20, kLoose = 0.005, kFewMissed = 0.001, kSeenOpen = 0.4;
// The disagreement (SurfaceQuality) of a view through both sides of a plate 0.4 spacings thick, which is open
// as soon as closed; and what the looseness of a closed surface must be of another's, to be taken in its
// place.
constexpr double kThinnest = 0.15, kMuchPlainer = 0.5;

// Handles that an open surface may have; how many times those of a closed one it has where it is torn, and
// what the score of that must be of its own. Measured: 0.33 of plates half a spacing thick, 0.77 of noise.
constexpr std::int64_t kWhole = 3, kTorn = 4;
constexpr double kFarBetter = 0.5;

// Which is best, chance and noise say: of an open surface, where some of it is turned over against the rest,
// the best of these is taken. No more than this share of neighbours face opposite ways where it is not.
constexpr RimRule kFirstRim{3, 0.03}, kSecondRim{2, 0.03}, kThirdRim{3, 0.3};
constexpr double kLittleConflict = 0.005;
// What a surface costs of which half shows its back to the point that it was seen from, times two.
constexpr double kTurnedPrice = 0.5;

// Components and handles a site above which two sides are not those of an open surface, but of thin walls,
// whose layers they confuse.
constexpr double kMostComplex = 0.015;

// Two sides are those of a plain open surface if they have no more than these: sites off their first cut, and
// components and handles, by sites; and neighbours that face opposite ways, by those of the first surface,
// where that has no inside and where it may have one. A lid must be more of the area than the last, where the
// result is closed; where it may be open, their score must be the better one.
constexpr double kPlainWeak = 0.02, kPlainComplex = 0.01, kPlainConflict = 0.75, kFarLessConflict = 0.25,
                 kLid = 0.2;

// Is there a film, and are all its vertices sites?
bool of_sites(const Surface& film) {
  return !film.triangles.empty() && std::count(film.site.begin(), film.site.end(), kNone) == 0;
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
  if (film.triangles.empty()) return std::numeric_limits<double>::infinity();
  const double sites = static_cast<double>(film.site.size()) + static_cast<double>(quality.off);
  // An inserted site is on the film, but where the film did not go by itself.
  return quality.disagreement + 0.1 * quality.conflict + kBridgePrice * quality.bridging +
         (static_cast<double>(quality.off) + 0.2 * static_cast<double>(inserted) +
          kComplexityPrice * static_cast<double>(quality.complexity)) /
             sites;
}

// Of an open surface whose faces may be rough; lower is better.
double Pipeline::looseness(const SurfaceQuality& quality) const {
  return kConflictPrice * quality.conflict +
         (static_cast<double>(quality.off) + kHandlePrice * static_cast<double>(quality.handles)) /
             static_cast<double>(sites_.size());
}

// Of a closed one that must not have been closed by its sides alone.
double Pipeline::looseness_closed(const SurfaceQuality& quality) const {
  return (static_cast<double>(quality.off) + kHandlePrice * static_cast<double>(quality.complexity)) /
         static_cast<double>(sites_.size());
}

void Pipeline::prepare(Tetrahedra tetrahedra) {
  report_.tetrahedra = static_cast<std::int64_t>(tetrahedra.size());
  mesh_ = make_tetrahedral_mesh(std::move(tetrahedra), sites_.perturbed);
  monitor_.enter("local evidence", 0.15);
  // The first belief's carving is one long thread of work that the evidence can run beside.
  const auto evidence = [&] { evidence_ = facet_evidence(mesh_, sites_.perturbed, geometry_); };
  const auto guess = [&] {
    if (method_of(options_) == Method::Labelling) guess_ = carve_belief(2, kInsideSlope);
  };
  tbb::parallel_invoke(guess, evidence);
}

void Pipeline::show(const Surface& film) const {
  if (!monitor_.execution().on_step) return;
  Mesh mesh;
  for (const Vec3& p : film.positions) mesh.positions.push_back(sites_.to_input(p));
  mesh.triangles.assign(film.triangles.begin(), film.triangles.end());
  call_back([&] { monitor_.execution().on_step(static_cast<int>(report_.steps.size()), mesh); });
}

Surface Pipeline::evolve(Surface film, const std::vector<Vec3>& sites, int max_steps, bool weights) {
  monitor_.enter("film", monitor_.share());
  if (report_.steps.empty()) show(film);
  FilmOptions options;
  options.ring = options_.ring;
  options.weights = weights;
  options.max_steps = max_steps;
  options.round = report_.rounds;
  options.after_step = [&](const StepRecord& record, const Surface& now) {
    report_.steps.push_back(record);
    // How many steps there will be is not known: each takes a twentieth of what is left.
    monitor_.progress(monitor_.share() + (0.95 - monitor_.share()) * 0.05);
    show(now);
    return true;
  };
  return evolve_film(std::move(film), sites, sites_.size(), voronoi_, options);
}

// What follows the last film step: sites still off the film are inserted where that is clean.
Pipeline::Candidate Pipeline::finish(Surface film) {
  Candidate candidate;
  // A film that never came off the first surface has vertices that are no sites.
  if (!of_sites(film)) return candidate;
  candidate.film = std::move(film);
  if (options_.insert_leftover) {
    monitor_.enter("insertion", monitor_.share());
    std::vector<char> on(sites_.size(), 0);
    for (Index s : candidate.film.site) on[s] = 1;
    std::vector<Index> off;
    for (std::size_t s = 0; s < sites_.size(); ++s)
      if (!on[s]) off.push_back(static_cast<Index>(s));
    candidate.inserted = insert_sites(candidate.film, sites_.perturbed, off, kReach);
  }
  candidate.quality = surface_quality(candidate.film, geometry_);
  return candidate;
}

std::vector<double> Pipeline::off_prices() const {
  std::vector<double> prices(sites_.size());
  parallel_each(prices.size(), [&](std::size_t v) {
    const double spacing = std::min(geometry_.spacing[v], near_spacing(geometry_, static_cast<Index>(v)));
    prices[v] = kOffPrice * spacing * spacing;
  });
  return prices;
}

// The surface of a cut by a belief, made manifold. The first cut that keeps most sites gives the topology;
// later ones, by growing conviction around the sites left off, where it should go.
Pipeline::Candidate Pipeline::cut(const std::vector<double>& belief, double conviction, bool open) {
  const std::size_t n = sites_.size();
  LabelCosts costs{evidence_.cost, std::vector<double>(mesh_.size()), off_prices()};
  parallel_each(mesh_.size(), [&](std::size_t t) {
    const auto& area = evidence_.area[t];
    costs.hold[t] = conviction * (double{area[0]} + area[1] + area[2] + area[3]) * belief[t];
  });

  Candidate candidate;
  std::optional<Sculptor> sculptor;
  std::vector<double> grown;  // instead of costs.hold, if there is a second cut
  std::vector<char> labels, aim;
  std::size_t labels_off = n + 1, aim_off = n + 1, last_off = n;
  for (int i = 0; i < kCuts; ++i) {
    monitor_.enter("sculpting", monitor_.share());
    if (!sculptor) sculptor.emplace(mesh_, evidence_, costs.hold, open);
    const std::vector<char> inside = sculptor->cut(monitor_.cancel());
    std::vector<char> sides(n, 0);  // of each site: 1 inside, 2 outside, 3 both: it is on the surface
    for (std::size_t t = 0; t < mesh_.size(); ++t)
      for (Index v : mesh_.tets.corners[t])
        if (v != kNone) sides[v] = static_cast<char>(sides[v] | (inside[t] ? 1 : 2));
    const std::size_t off = n - static_cast<std::size_t>(std::count(sides.begin(), sides.end(), 3));
    if (i == 0) candidate.weak = static_cast<double>(off) / static_cast<double>(n);
    if (off < labels_off &&
        static_cast<double>(n - std::min(n, labels_off)) < kKeptShare * static_cast<double>(n))
      labels = inside, labels_off = off;
    if (off < aim_off) aim = inside, aim_off = off;
    const bool stalled =
        i > 0 && 2 * off<n&& static_cast<double>(off)> kStalled * static_cast<double>(last_off);
    if (off == 0 || stalled) break;
    last_off = off;
    if (grown.empty()) grown = costs.hold;
    for (std::size_t t = 0; t < mesh_.size(); ++t)
      for (Index v : mesh_.tets.corners[t])
        if (v != kNone && sides[v] != 3) {
          const double before = grown[t];
          grown[t] *= kConvictionGrowth;
          sculptor->hold_firmly(static_cast<Index>(t), before, grown[t]);
          break;
        }
  }
  sculptor.reset();  // it is large
  std::vector<double>().swap(grown);
  // What keeps fewer than half has lost the shape.
  if (2 * aim_off > n) return candidate;

  monitor_.enter("manifold", monitor_.share());
  Labelling labelling(mesh_, geometry_, costs, labels, monitor_.cancel());
  repair(labelling, exempt(labels));
  warp(labelling, aim);
  unfold(labelling);
  if (options_.insert_leftover) reach(labelling);
  candidate.inserted = labelling.counts.reached;
  candidate.film = film_of(labels);
  candidate.labels = std::move(labels);
  candidate.hold = std::move(costs.hold);
  return candidate;
}

// Where the surface need not be a manifold: an open one must be when its bridges are gone.
std::vector<char> Pipeline::exempt(const std::vector<char>& labels) const {
  if (!open_) return {};
  return manifold_without_bridges(tetrahedral_boundary(mesh_, labels), sites_.perturbed, geometry_);
}

Surface Pipeline::film_of(const std::vector<char>& labels) const {
  Surface film = unsorted_surface_of_sites(tetrahedral_boundary(mesh_, labels), sites_.perturbed);
  if (open_) remove_bridges(film, geometry_);
  return film;
}

// Of the candidate that was chosen, as its handles tell a bad one; or of copies of two, to compare them.
// Leaves no `hold`.
Pipeline::Candidate Pipeline::without_gaps(Candidate candidate, Mend mend) {
  if (candidate.labels.empty()) return candidate;
  monitor_.enter("gaps", monitor_.share());
  const LabelCosts costs{evidence_.cost, std::move(candidate.hold), off_prices()};
  Labelling labelling(mesh_, geometry_, costs, candidate.labels, monitor_.cancel());
  repair(labelling, exempt(candidate.labels));  // it takes the census
  if (mend == Mend::Plugs) {
    mend_plugs(labelling);
    if (labelling.counts.tunnels + labelling.counts.tears == 0) return candidate;
  } else {
    filmsticking::mend(labelling, sites_.perturbed);
  }
  unfold(labelling);
  if (options_.insert_leftover) reach(labelling);
  candidate.inserted += labelling.counts.reached;
  candidate.film = film_of(candidate.labels);
  return judged(std::move(candidate));
}

Pipeline::Candidate Pipeline::judged(Candidate candidate) const {
  candidate.quality = surface_quality(candidate.film, geometry_);
  return candidate;
}

// Sure of the inside from a third of a spacing below the limit, of the outside from 1 / slope above it.
std::vector<double> Pipeline::carve_belief(double limit, double slope) const {
  std::vector<double> belief =
      carve_widths(mesh_, sites_.perturbed, geometry_.spacing, limit - 1 / kInsideSlope, limit + 1 / slope);
  for (double& b : belief) b = (limit - b) * (b > limit ? slope : kInsideSlope);
  return belief;
}

std::vector<double> Pipeline::winding_belief(const Surface& film) const {
  const WindingNumber winding(sites_.perturbed, film_dipoles(film, sites_.size()));
  std::vector<double> belief(mesh_.size(), -1);
  parallel_each(mesh_.size(), [&](std::size_t t) {
    if (mesh_.tets.infinite(static_cast<Index>(t))) return;
    Vec3 centre = Vec3::Zero();
    for (Index i : mesh_.tets.corners[t]) centre += sites_.perturbed[i] / 4;
    belief[t] = std::clamp(2 * winding(centre) - 1, -1.0, 1.0);
  });
  return belief;
}

std::vector<double> Pipeline::film_belief(const Surface& film) const {
  if (options_.field == FieldMethod::Poisson) {
    std::vector<double> belief = poisson_belief(mesh_, sites_.perturbed, film_dipoles(film, sites_.size()));
    if (!belief.empty()) return belief;
  }
  return winding_belief(film);
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
  costs.hold[fattest] = std::numeric_limits<double>::max();  // it stays
  Labelling labelling(mesh_, geometry_, costs, labels);
  repair(labelling);  // there is nothing to repair; it takes the census
  if (options_.insert_leftover) reach(labelling);
  report_.inserted = labelling.counts.reached;
  return unsorted_surface_of_sites(tetrahedral_boundary(mesh_, labels), sites_.perturbed);
}

// Nothing to remove and nothing to correct.
bool Pipeline::settled(const Candidate& candidate) const {
  return candidate.inserted == 0 && candidate.quality.off == 0 && candidate.quality.wide_faces == 0;
}

// Normals fitted to neighbourhoods are wrong where these reach across a thin wall or an edge; the film's own
// are better there, once it is about right: with them as evidence, it is cut again. What comes of it counts
// only if it is better by the measure that knows the fitted normals, gives up hardly any sites, and is not
// more complex, as it is or with the gaps of both filled: a new handle may be a leak.
Pipeline::Candidate Pipeline::refined(Candidate best) {
  for (int round = 0; round < kRefinements && !best.labels.empty(); ++round) {
    monitor_.enter("local evidence", monitor_.share());
    evidence_ = {};  // it is large
    {
      SiteGeometry geometry = geometry_;
      geometry.normal = surface_normals(best.film, std::move(geometry.normal));
      evidence_ = facet_evidence(mesh_, sites_.perturbed, geometry);
    }
    monitor_.enter("signed field", monitor_.share());
    std::vector<double> guess(mesh_.size());
    for (std::size_t t = 0; t < guess.size(); ++t) guess[t] = best.labels[t] ? 1 : -1;
    Candidate next =
        judged(cut(signed_field(mesh_, evidence_, std::move(guess), monitor_.cancel()), kConviction));
    const double given_up = static_cast<double>(next.quality.off - best.quality.off);
    if (!(next.score() < best.score()) || given_up > kGivenUp * static_cast<double>(sites_.size())) break;
    // A chance gap is no leak. They are filled in copies, to compare: a surface whose gaps are filled holds
    // on to what is wrong beside them when it is cut again.
    if (next.quality.complexity > best.quality.complexity) {
      const std::int64_t filled = without_gaps(next).quality.complexity;
      if (filled > 1 && filled > without_gaps(best).quality.complexity) break;
    }
    best = std::move(next);
  }
  return best;
}

Pipeline::Candidate Pipeline::cut_sides(const RimRule& rim, const Vec3* viewpoint, bool open) {
  monitor_.enter("two sides", monitor_.share());
  return judged(
      cut(two_sides(mesh_, sites_.perturbed, evidence_, geometry_, rim, viewpoint, monitor_.cancel()),
          kSidesConviction, open));
}

// By the facets alone. Where some of an open surface is turned over against the rest, by other rules as well,
// and if it is a scan from one side, by the point that it was seen from, which the first surfaces tell.
Pipeline::Candidate Pipeline::cut_two_sides() {
  const auto by_rule = [&](const RimRule& rim, const Vec3* viewpoint) {
    return cut_sides(rim, viewpoint, open_);
  };
  Candidate best = by_rule(kFirstRim, nullptr);
  if (!open_ || best.quality.conflict <= kLittleConflict) return best;
  Candidate next = by_rule(kSecondRim, nullptr);
  if (next.score() < best.score()) best = std::move(next);
  if (best.quality.conflict <= kLittleConflict) return best;
  monitor_.enter("two sides", monitor_.share());
  const Vec3 viewpoint = common_viewpoint(best.film);
  const bool one_view = !best.film.triangles.empty() && seen_once(best.film, viewpoint, monitor_.cancel());
  next = by_rule(kThirdRim, one_view ? &viewpoint : nullptr);
  const auto price = [&](const Candidate& sides) {
    return sides.score() + (one_view ? kTurnedPrice * turned_away(sides.film, viewpoint) : 0);
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

std::optional<DepthImage> Pipeline::visible_surface() {
  std::optional<DepthImage> image = image_of(exact_places());
  if (image) viewpoint_ = image->viewpoint;
  return image;
}

// All of the sites, seen from the viewpoint that the caller gives, if they may be: a thinned or rough depth
// image is none by its pixels.
std::optional<DepthImage> Pipeline::given_view() {
  const std::optional<Vec3> viewpoint = given_viewpoint();
  if (!viewpoint) return {};
  monitor_.enter("depth image", monitor_.share());
  return image_from(exact_places(), *viewpoint, geometry_, monitor_.cancel());
}

// They are, if what is found without that is open, seen from there, and has no fewer folds and handles: an
// image has none by nature. Where they are about as good, the image knows which side is seen.
bool Pipeline::is_better_view(const DepthImage& image, Surface found) const {
  Candidate open;
  open.film = std::move(found);
  remove_bridges(open.film, geometry_);
  if (crossed_oddly(open.film, image.viewpoint, monitor_.cancel()) < kSeenOpen) return false;
  const SurfaceQuality other = judged(std::move(open)).quality;
  const double off = static_cast<double>(std::max<std::int64_t>(0, image.quality.off - other.off));
  return off <= kFewMissed * static_cast<double>(sites_.size()) &&
         looseness(image.quality) < looseness(other) + kLoose;
}

// By what is before and behind a depth image. Its gaps are those of its steps.
Pipeline::Candidate Pipeline::cut_image(const Vec3& viewpoint) {
  const std::vector<double> sides = depth_image_sides(mesh_, sites_.perturbed, viewpoint, monitor_.cancel());
  return without_gaps(judged(cut(sides, kConviction)), Mend::Plugs);
}

// By local evidence alone; where its first cut leaves many sites off, in other ways, too. Of a depth image,
// all of these know less than the image.
Pipeline::Candidate Pipeline::carve() {
  monitor_.enter("signed field", 0.25);
  Candidate best = cut(signed_field(mesh_, evidence_, std::move(guess_), monitor_.cancel()), kConviction);
  best = judged(std::move(best));
  if (best.weak <= kLittleTrouble && !best.film.triangles.empty()) {
    // With a handle or a second part it may have walls, if no thin ones.
    if (best.quality.complexity > 1) best = without_gaps(std::move(best), Mend::Plugs);
    return best;
  }
  if (best.weak <= kSomeTrouble) return carve_further(std::move(best), false);

  if (!open_)
    if (const auto image = image_of(sites_.perturbed))
      if (Candidate closed = cut_image(image->viewpoint); has_shape(closed)) return closed;
  const std::optional<DepthImage> view = given_view();
  Candidate sides = cut_two_sides();
  const auto by_view = [&] {
    if (!open_) return cut_image(view->viewpoint);
    Candidate seen;
    seen.film = view->surface;
    viewpoint_ = view->viewpoint;
    return seen;
  };
  if (view && view->quality.disagreement <= kThinnest) {
    // A closed surface that follows both sides of an open one tells nothing.
    Surface found =
        open_ ? (sides.score() < best.score() ? sides : best).film : cut_sides(kFirstRim, nullptr, true).film;
    if (is_better_view(*view, std::move(found)))
      if (Candidate seen = by_view(); open_ || has_shape(seen)) return seen;
  }
  // What is rough may be a thin wall, too, but that comes out closed and plain.
  if (open_) {
    Candidate first = best;
    best = closed_if_torn(with_sides(std::move(best), std::move(sides)), std::move(first));
    return view && is_better_view(*view, best.film) ? by_view() : std::move(best);
  }
  best = with_sides(std::move(best), std::move(sides));
  if (!view) return best;
  Candidate seen = by_view();
  const bool plainer = looseness_closed(seen.quality) < kMuchPlainer * looseness_closed(best.quality);
  return has_shape(seen) && plainer ? std::move(seen) : std::move(best);
}

// An open surface with handles may be a thin wall's, torn. `closed`: the first candidate. If carving makes a
// far better surface of it, with hardly a handle and without leaving off more, it is closed.
Pipeline::Candidate Pipeline::closed_if_torn(Candidate open, Candidate closed) {
  if (open.quality.handles <= kWhole) return open;
  open_ = false;
  if (!closed.labels.empty()) closed.film = film_of(closed.labels), closed = judged(std::move(closed));
  bool two_sided = false;
  closed = by_widths(std::move(closed), two_sided);
  if (closed.score() < open.score()) closed = without_gaps(refined(std::move(closed)));
  open_ = true;
  const bool whole = closed.score() < kFarBetter * open.score() && closed.quality.off <= open.quality.off &&
                     kTorn * closed.quality.complexity <= open.quality.handles;
  return whole ? std::move(closed) : std::move(open);
}

bool Pipeline::has_shape(const Candidate& candidate) {
  return !candidate.film.triangles.empty() && candidate.weak <= kNoInside;
}

// `sides`, if these are a plain open surface; else what carving makes of the better one.
Pipeline::Candidate Pipeline::with_sides(Candidate best, Candidate sides) {
  const double complexity =
      static_cast<double>(sides.quality.complexity) / static_cast<double>(sites_.size());
  // A plain open surface: nothing else can be better, and all else takes long there. Closed, it has faces
  // that nothing supports, and so a bad score; but what is closed and thin instead has none, and winds
  // between its sides, where neighbours face both ways.
  const bool no_inside = best.weak > kNoInside;
  const bool better = sides.score() < (no_inside ? 1 : kMuchBetter) * best.score();
  const bool best_open = open_ && sides.weak <= kLittleTrouble && complexity <= kLittleTrouble && better;
  const bool open = open_ ? sides.score() < best.score() : sides.quality.bridging > kLid;
  const bool plain =
      open && sides.weak <= kPlainWeak && complexity <= kPlainComplex &&
      sides.quality.conflict < (no_inside ? kPlainConflict : kFarLessConflict) * best.quality.conflict;
  if (best_open || plain) return open_ ? std::move(sides) : without_gaps(std::move(sides));
  const bool two_sided = complexity <= kMostComplex && better;
  return carve_further(two_sided ? std::move(sides) : std::move(best), two_sided);
}

// By carving at a few widths and convictions. `two_sided`: with these there still is no inside.
Pipeline::Candidate Pipeline::by_widths(Candidate best, bool& two_sided) {
  for (const auto& carving : kCarvings) {
    // Of slabs and shells it made nothing better than two sides, and it takes as long again.
    if (two_sided && carving.conviction > kConviction) continue;
    monitor_.enter("carving", monitor_.share());
    Candidate other = judged(cut(carve_belief(carving.width, kCarveSlope), carving.conviction));
    if (other.score() < carving.share * best.score()) best = std::move(other), two_sided = false;
  }
  return best;
}

// The best of these is cut again by its own normals. Where there is no telling inside from outside (open
// surfaces), by the film from the sphere.
Pipeline::Candidate Pipeline::carve_further(Candidate best, bool two_sided) {
  best = by_widths(std::move(best), two_sided);
  if (!two_sided) best = refined(std::move(best));
  best = without_gaps(std::move(best));
  const auto enough = static_cast<std::int64_t>(kMuchTrouble * static_cast<double>(sites_.size()));
  if (!best.film.triangles.empty() && best.quality.off <= enough) return best;
  Candidate film = finish(film_from_outside());
  if (film.score() < best.score()) best = std::move(film);
  return best;
}

// The surfaces to start from, the next where the film of one before it failed: a wrap that is finer than the
// gaps between the points crawls through them, and a coarser one or the sphere does not.
std::vector<std::function<Surface()>> Pipeline::first_surfaces() const {
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

// The film by plain steps from the first surface, and by virtual sites and weights once it stalls.
Surface Pipeline::film_from_outside() {
  if (voronoi_.offset.empty()) voronoi_ = voronoi_diagram(mesh_.tets, sites_.perturbed);
  Surface film;
  for (const auto& first : first_surfaces()) {
    monitor_.enter("first surface", 0.2);
    const std::size_t steps_before = report_.steps.size();
    film = evolve(first(), sites_.perturbed, options_.max_steps, false);
    // A leaked film is a double skin: nearly every site has two regions of it.
    const bool leaked = report_.steps.size() > steps_before &&
                        2 * report_.steps[steps_before].regions_repaired > report_.sites;
    if (of_sites(film) && !leaked) break;
  }
  if (!of_sites(film)) return {};
  // A way out, not what the caller chose: the virtual sites would take the square of the tetrahedra.
  if (method_of(options_) == Method::Labelling && report_.tetrahedra > kMostForVirtual * report_.sites)
    return film;
  // Before the film moves: the order in which a call's arguments are evaluated is the compiler's.
  const std::vector<Vec3> sites = with_virtual_sites(film);
  film = evolve(std::move(film), sites, options_.max_steps, options_.weights);
  // A film that was stopped may still hold the places of virtual sites; a step without them drops these.
  return of_sites(film) ? std::move(film) : evolve(std::move(film), sites_.perturbed, 1, false);
}

// Virtual sites for the cavities that the film has not reached: on the outer medial axis, where a ball can
// roll to from outside, beside sites off the film. Given everywhere and from the first step they would pull
// the film through the shape before the points are on it.
std::vector<Vec3> Pipeline::with_virtual_sites(const Surface& film) const {
  std::vector<Vec3> sites = sites_.perturbed;
  if (options_.virtual_sites == 0) return sites;
  std::vector<char> off(sites.size(), 1), wanted(mesh_.size(), 0);
  for (Index s : film.site)
    if (s != kNone) off[s] = 0;
  const std::vector<double> width = carve_widths(mesh_, sites, geometry_.spacing, 1, 2);
  for (std::size_t t = 0; t < mesh_.size(); ++t) {
    if (mesh_.tets.infinite(static_cast<Index>(t)) || width[t] < 2) continue;
    for (Index i : mesh_.tets.corners[t]) wanted[t] = static_cast<char>(wanted[t] | off[i]);
  }
  const std::vector<Vec3> extra = virtual_sites(mesh_, geometry_.spacing, options_.virtual_sites, wanted);
  sites.insert(sites.end(), extra.begin(), extra.end());
  return sites;
}

void Pipeline::rounds(Candidate& best) {
  if (options_.field == FieldMethod::None) return;
  for (int round = 0; round < options_.max_rounds && !settled(best); ++round) {
    ++report_.rounds;
    monitor_.enter("field", 0.5 + 0.45 * round / options_.max_rounds);
    const std::vector<double> belief = film_belief(best.film);
    // Poisson's surface is taken as it is; only sculpting weighs it against the evidence.
    Candidate next = judged(cut(belief, options_.field == FieldMethod::Poisson ? 1e6 : kConviction));
    // One round is what the paper does, better or not by our own measure; more must earn their keep.
    if (next.film.triangles.empty() || (round > 0 && !(next.score() < best.score()))) break;
    best = std::move(next);
  }
}

Surface Pipeline::run(Tetrahedra tetrahedra) {
  prepare(std::move(tetrahedra));
  Candidate best;
  if (method_of(options_) == Method::Labelling) {
    best = carve();
    show(best.film);
  } else {
    best = finish(film_from_outside());
    rounds(best);
  }
  report_.inserted = best.inserted;
  return std::move(best.film);
}

}  // namespace filmsticking
