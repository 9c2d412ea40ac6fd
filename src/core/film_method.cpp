// SPDX-License-Identifier: GPL-3.0-or-later
#include "film_method.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "film/initial_surface.h"
#include "film/winding_number.h"
#include "geometry/parallel.h"
#include "show_step.h"

namespace filmsticking {
namespace {

// Ball of the alpha wrap, in longest sides of the box.
constexpr double kWrapAlpha = 0.05;
// Tetrahedra per site. More: the points are on no surface, but on two curves, say; no virtual sites or
// weights.
constexpr std::int64_t kMostForFilm = 64;
// Fraction of sites that a film must reach. Fewer: its start leaked or ran past the points; try the next one.
constexpr double kReached = 0.5;

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

// Is there nothing to remove and nothing to correct?
bool needs_no_round(const Candidate& candidate) {
  return candidate.inserted == 0 && candidate.quality.off == 0 && candidate.quality.wide_faces == 0;
}

}  // namespace

FilmMethod::FilmMethod(Cutter& cutter, const SiteSet& sites, const SiteGeometry& geometry,
                       const Options& options, Monitor& monitor, Report& report)
    : cutter_(cutter),
      sites_(sites),
      geometry_(geometry),
      options_(options),
      monitor_(monitor),
      report_(report) {}

Candidate FilmMethod::run() {
  Candidate best = film_from_outside();
  if (options_.field == FieldMethod::None || best.empty()) return best;
  for (int round = 0; round < options_.max_rounds && !needs_no_round(best); ++round) {
    ++report_.rounds;
    monitor_.progress(0.5 + 0.45 * round / options_.max_rounds);
    Candidate next = after_last_step(without_dangling(best));
    if (!(next.energy < best.energy)) break;
    best = std::move(next);
  }
  return best;
}

// The surfaces that a film starts from, in the order in which they are tried. A wrap finer than the gaps
// between the points leaks through them; a coarser one or the sphere does not.
std::vector<std::function<Surface()>> FilmMethod::first_films() const {
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

FilmOptions FilmMethod::film_options() {
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
    if (monitor_.execution().on_step) show_step(film_surface(film, sites_.size()), sites_, monitor_, report_);
  };
  return options;
}

// Evolves a film from the first start from which it reaches the points.
Candidate FilmMethod::film_from_outside() {
  Candidate film;
  for (const auto& first : first_films()) {
    monitor_.enter("first surface", 0.2);
    const Surface start = first();
    monitor_.enter("film", monitor_.share());
    if (report_.steps.empty()) show_step(start, sites_, monitor_, report_);
    const TetrahedralMesh& mesh = cutter_.mesh();
    std::vector<char> labels =
        evolve_film(enclosure(start), mesh, sites_.perturbed, geometry_.spacing, film_options());
    // Where a site is singular, the dearer side gives way.
    const bool nearest = options_.ring == RingChoice::Nearest;
    film = nearest ? cutter_.by_film(std::move(labels), prices_by_distance(mesh, cutter_.evidence()))
                   : cutter_.by_film(std::move(labels), cutter_.evidence().cost);
    if (static_cast<double>(film.quality.off) < kReached * static_cast<double>(sites_.size())) break;
  }
  return film;
}

std::vector<double> FilmMethod::winding_belief(const Surface& film) const {
  const WindingNumber winding(sites_.perturbed, film_dipoles(film, geometry_.spacing));
  const Tetrahedra& tets = cutter_.mesh().tets;
  std::vector<double> belief(cutter_.mesh().size(), -1);
  parallel_each(belief.size(), [&](std::size_t t) {
    if (tets.infinite(static_cast<Index>(t))) return;
    Vec3 centre = Vec3::Zero();
    for (Index i : tets.corners[t]) centre += sites_.perturbed[i] / 4;
    belief[t] = std::clamp(2 * winding(centre) - 1, -1.0, 1.0);
  });
  return belief;
}

// Cuts by what the film says of inside and outside (paper, section 5): its normals decide the votes, and its
// winding number or Poisson's equation on the tetrahedra the belief.
Candidate FilmMethod::without_dangling(const Candidate& film) {
  cutter_.use_normals_of(film.surface);
  const bool open = may_be_open(options_);
  if (options_.field == FieldMethod::Poisson) return cutter_.cut_field(belief_of(film.labels), open);
  monitor_.enter("field", monitor_.share());
  return cutter_.cut(winding_belief(film.surface), kConviction, open);
}

// The paper's last step: one film step from the surface that the field gave. It moves the surface as far as
// its topology, which the field decided, allows.
Candidate FilmMethod::after_last_step(Candidate candidate) {
  if (candidate.labels.empty()) return candidate;
  monitor_.enter("film", monitor_.share());
  FilmOptions options = film_options();
  options.weights = false, options.max_steps = 2;
  const std::vector<char> aim =
      evolve_film(candidate.labels, cutter_.mesh(), sites_.perturbed, geometry_.spacing, options);
  return cutter_.warped(std::move(candidate), aim);
}

}  // namespace filmsticking
