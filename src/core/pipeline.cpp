// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "evidence/sight.h"
#include "film/dense_film.h"
#include "film/film_step.h"
#include "film/initial_surface.h"
#include "film/stability.h"
#include "film_method.h"
#include "geometry/parallel.h"
#include "points/site_viewpoints.h"
#include "show_step.h"
#include "surface/viewpoint.h"

namespace filmsticking {
namespace {

// Width of the narrowest place through which dense virtual sites lead a film, in spacings. Virtual sites keep
// twice the spacing from all points (virtual_sites.h).
constexpr double kFilmWidth = 2;

// Fraction of sites missed by the first cut. < 1 %: the cut is clear; no other is tried.
constexpr double kClear = 0.01;
// > 10 %: there may be no inside; the points may be an open surface.
constexpr double kUnclear = 0.1;

// Carvings. Width: the ball that carves the outside does not enter narrower places, in spacings. A weak
// conviction gives up shapes whose walls are thin nearly everywhere. The last width is that of some chance
// gaps.
constexpr struct { double width, conviction; } kCarvings[] = {{2, kConviction}, {4, kConviction}, {1.5, 0.5}};

// Candidates that are refined: so many of the least energies. Three choose as two do.
constexpr std::size_t kBest = 2;

// Fraction of lines of sight that leave the hull, below which the sensors are inside.
constexpr double kFewLeave = 0.1;
// Distance of the farthest single sensor, in box sides: as far as infinity for a depth image.
constexpr double kFarSensor = 50;
// Fraction of blocked lines of sight above which the sensors were elsewhere.
constexpr double kWrongSight = 0.1;

// Fraction of near sites with opposite normals. <= 0.5 %: neighbours agree; a viewpoint would change nothing.
constexpr double kLittleConflict = 0.005;
// Price per fraction of area that faces away from the viewpoint.
constexpr double kTurnedPrice = 0.5;

bool is_clear(const Candidate& cut) { return !cut.empty() && cut.missed <= kClear; }

}  // namespace

Pipeline::Pipeline(const PointsView& points, const SiteSet& sites, const SiteGeometry& geometry,
                   const Options& options, Monitor& monitor, Report& report)
    : points_(points),
      sites_(sites),
      geometry_(geometry),
      options_(options),
      monitor_(monitor),
      report_(report),
      cutter_(points, sites, geometry, options, monitor),
      open_(may_be_open(options)),
      guessed_(!options.trust_viewpoint && !options.viewpoints && !options.view_direction) {}

FoundSurface Pipeline::run(Tetrahedra tetrahedra) {
  report_.tetrahedra = static_cast<std::int64_t>(tetrahedra.size());
  cutter_.take(std::move(tetrahedra));
  Candidate best;
  if (method_of(options_) == Method::Labelling) {
    best = labelling();
    show_step(best.surface, sites_, monitor_, report_);
  } else {
    best = FilmMethod(cutter_, sites_, geometry_, options_, monitor_, report_).run();
  }
  report_.inserted = best.inserted;
  std::vector<float> stability;
  if (options_.stability && !best.labels.empty()) {
    monitor_.enter("stability", monitor_.share());
    stability = site_stability(cutter_.mesh(), sites_.perturbed, best.labels);
  }
  return {std::move(best.surface), best.viewpoint, std::move(viewpoints_), std::move(stability)};
}

// Sight that many lines contradict is no sight: the sensors were elsewhere.
bool Pipeline::look(std::vector<Vec3> from) {
  if (from.empty()) return false;
  monitor_.enter("sight", monitor_.share());
  Sight sight = lines_of_sight(cutter_.mesh(), sites_.perturbed, geometry_, cutter_.evidence(), from,
                               monitor_.cancel());
  if (static_cast<double>(sight.blocked) > kWrongSight * static_cast<double>(sight.lines)) return false;
  const bool inside = static_cast<double>(sight.leaving) < kFewLeave * static_cast<double>(sight.lines);
  if (inside && guessed_) return false;
  cutter_.use_sight(std::move(sight.votes));
  viewpoints_ = std::move(from);
  inside_ = inside;
  return true;
}

// Most clouds are clear: the first cut, by the field that starts from the film, misses hardly a site.
Candidate Pipeline::labelling() {
  if (!guessed_) look(site_viewpoints(sites_, options_));
  if (inside_) {
    Candidate room = cutter_.cut_field(cutter_.turn_sight_over(), open_);
    if (is_clear(room)) return without_gaps(std::move(room));
    cutter_.turn_sight_over();
  }
  const std::vector<char> film = film_from_sphere();
  Candidate first = cutter_.cut_field(belief_of(film), open_);
  if (!viewpoints_.empty() && !inside_ && !is_clear(first))
    first = or_blind(std::move(first), belief_of(film));
  if (is_clear(first)) return without_gaps(std::move(first));

  if (first.missed > kUnclear && viewpoints_.empty()) first = or_seen(std::move(first), belief_of(film));
  // Their energies change order once their own normals are known and chance gaps are plugged.
  Candidate best;
  for (Candidate& start : starts(std::move(first))) {
    Candidate fine = cutter_.plugged(cutter_.refined(std::move(start)));
    if (best.empty() || less(fine, best)) best = std::move(fine);
  }
  best = cutter_.mended(std::move(best));
  return inside_ ? or_room(std::move(best)) : best;
}

// A clear cut with a handle or a second component may have walls, if no thin ones.
Candidate Pipeline::without_gaps(Candidate clear) {
  return clear.quality.complexity > 1 ? cutter_.plugged(std::move(clear)) : clear;
}

// Sight from outside is wrong where the cut is clear only without it.
Candidate Pipeline::or_blind(Candidate seen, std::vector<double> guess) {
  std::vector<float> votes = cutter_.forget_sight();
  Candidate blind = cutter_.cut_field(std::move(guess), open_);
  if (is_clear(blind)) {
    viewpoints_.clear();
    inside_ = false;
    return blind;
  }
  cutter_.use_sight(std::move(votes));
  return seen;
}

// A depth image shows its viewpoint by its raster; any other cloud may have been seen from where a guess
// says. Either is believed if the cut by it becomes clearer.
Candidate Pipeline::or_seen(Candidate first, std::vector<double> guess) {
  std::optional<DepthImage> image;
  if (!open_) image = image_of(sites_.perturbed);
  if (!look(image ? std::vector<Vec3>(sites_.size(), image->viewpoint) : site_viewpoints(sites_, options_)))
    return first;
  Candidate seen = cutter_.cut_field(std::move(guess), open_);
  if (!seen.empty() && seen.missed <= kUnclear && less(seen, first)) return seen;
  cutter_.forget_sight();
  viewpoints_.clear();
  return first;
}

// Sensors that are inside the hull may be in a room: its air is the inside then, its walls are no shells.
Candidate Pipeline::or_room(Candidate best) {
  Candidate room = cutter_.refined(cutter_.cut_field(cutter_.turn_sight_over(), open_));
  room = cutter_.mended(cutter_.plugged(std::move(room)));
  return less(room, best) ? std::move(room) : std::move(best);
}

// The best of all beliefs, the least energy first.
std::vector<Candidate> Pipeline::starts(Candidate first) {
  std::vector<Candidate> best;
  const auto add = [&](Candidate start) {
    if (start.empty()) return;
    best.insert(std::upper_bound(best.begin(), best.end(), start, less), std::move(start));
    if (best.size() > kBest) best.pop_back();
  };
  const bool unclear = first.missed > kUnclear;
  add(std::move(first));
  for (const auto& [width, conviction] : kCarvings) add(cutter_.cut_ball(width, conviction, open_));
  if (unclear) add(two_sides(best.empty() ? nullptr : &best.front()));
  return best;
}

// The two sides of an open surface by the facets alone. Where neighbours on it disagree and it is a scan from
// one side, also by the viewpoint that it shows.
Candidate Pipeline::two_sides(const Candidate* rival) {
  Candidate best = cutter_.cut_sides(nullptr, open_, rival);
  if (!open_ || best.empty() || best.quality.conflict <= kLittleConflict) return best;
  monitor_.enter("two sides", monitor_.share());
  const Vec3 viewpoint = common_viewpoint(best.surface);
  if (!is_seen_once(best.surface, viewpoint, monitor_.cancel())) return best;
  Candidate seen = cutter_.cut_sides(&viewpoint, open_, rival);
  const auto price = [&](const Candidate& sides) {
    return sides.energy + kTurnedPrice * turned_away_share(sides.surface, viewpoint);
  };
  return price(seen) < price(best) ? std::move(seen) : std::move(best);
}

// With dense virtual sites. Its steps are recorded where the caller watches them; else they are not made one
// by one.
std::vector<char> Pipeline::film_from_sphere() {
  monitor_.enter("film", monitor_.share());
  const TetrahedralMesh& mesh = cutter_.mesh();
  std::function<void(const std::vector<char>&)> after_step;
  if (monitor_.execution().on_step) {
    show_step(bounding_sphere(sites_.perturbed), sites_, monitor_, report_);
    after_step = [&](const std::vector<char>& inside) {
      const Surface film = film_surface(mesh.tets, inside, sites_.perturbed);
      StepRecord record;
      std::vector<char> on(sites_.size(), 0);
      for (const Index s : film.site) on[s] = 1;
      record.attracted = std::count(on.begin(), on.end(), 1);
      report_.steps.push_back(record);
      show_step(film, sites_, monitor_, report_);
    };
  }
  return dense_film(mesh, sites_.perturbed, geometry_.spacing, kFilmWidth, after_step);
}

std::vector<Vec3> Pipeline::exact_places() const {
  std::vector<Vec3> places(sites_.size());
  parallel_each(places.size(), [&](std::size_t s) { places[s] = sites_.exact(points_, s); });
  return places;
}

// One sensor of all points, not farther than depth images may be seen from.
std::optional<Vec3> Pipeline::given_viewpoint() const {
  const std::vector<Vec3> from = site_viewpoints(sites_, options_);
  if (from.empty()) return {};
  if (options_.view_direction) return kFarSensor * (from[0] - sites_.perturbed[0]).normalized();
  if (!from[0].allFinite() ||
      std::any_of(from.begin(), from.end(), [&](const Vec3& p) { return p != from[0]; }))
    return {};
  return from[0].norm() > kFarSensor ? kFarSensor * from[0].normalized() : from[0];
}

std::optional<DepthImage> Pipeline::image_of(const std::vector<Vec3>& places) {
  monitor_.enter("depth image", monitor_.share());
  return depth_image(places, geometry_, given_viewpoint(), monitor_.cancel());
}

std::optional<FoundSurface> Pipeline::visible_surface() {
  std::optional<DepthImage> image = image_of(exact_places());
  if (!image) return {};
  return FoundSurface{std::move(image->surface), image->viewpoint, {}, {}};
}

Surface Pipeline::around_one_tetrahedron() {
  Candidate last = cutter_.around_one_tetrahedron();
  report_.inserted = last.inserted;
  return std::move(last.surface);
}

}  // namespace filmsticking
