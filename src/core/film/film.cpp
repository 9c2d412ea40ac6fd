// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/film.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "film/attraction_weights.h"
#include "film/cavities.h"
#include "film/virtual_sites.h"

namespace filmsticking {
namespace {

// A film stalls when a step brings fewer than this share of the points onto it.
constexpr double kRise = 0.005;

class Evolution {
 public:
  Evolution(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites, const std::vector<double>& spacing,
            const FilmOptions& options)
      : mesh_(mesh),
        points_(sites),
        spacing_(spacing),
        options_(options),
        plain_(std::make_shared<const PowerComplex>(sites, mesh.tets)) {}

  void start(const std::function<bool(const Vec3&)>& contains) {
    film_ = first_ = film_within(contains, plain_);
    if (options_.virtual_sites != 0) {
      std::vector<Vec3> sites = points_;
      const std::vector<Vec3> extra = virtual_sites(mesh_, spacing_, options_.virtual_sites, first_.inside);
      sites.insert(sites.end(), extra.begin(), extra.end());
      if (!extra.empty()) film_ = film_within(contains, complex_of(std::move(sites), {}));
    }
    if (std::count(first_.inside.begin(), first_.inside.end(), 1) > 0) return;
    // The points are so flat that all orthocentres are far away: their hull is the film.
    for (std::size_t t = 0; t < first_.inside.size(); ++t)
      first_.inside[t] = static_cast<char>(!plain_->tetrahedra().infinite(static_cast<Index>(t)));
  }

  void start(std::vector<char> labels) { film_ = first_ = {plain_, std::move(labels)}; }

  // Ends: each step but three raises the number of points on the film.
  std::vector<char> run() {
    enum { kPlain, kCavities, kWeights } by = kPlain;
    std::size_t best = 0;
    bool stalled = false;
    std::vector<char> sides = site_sides(film_);
    for (int step = 1; step < options_.max_steps; ++step) {
      options_.limits.cancel();
      if (stalled) {
        if (by == kWeights || !options_.weights) break;
        by = by == kPlain ? kCavities : kWeights;
      }
      const auto start = std::chrono::steady_clock::now();
      StepRecord record;
      std::shared_ptr<const PowerComplex> complex = by == kWeights    ? attracting(sides, record)
                                                    : by == kCavities ? plain_
                                                                      : kept_sites(sides, record);
      if (by == kWeights && record.weighted == 0) break;
      std::size_t on = advance(std::move(complex), sides, record);
      if (by == kCavities) on = leave_cavities(sides, record);
      const auto enough = static_cast<std::size_t>(kRise * static_cast<double>(points_.size()));
      stalled = on <= best + enough;
      best = std::max(best, on);
      finish(record, start);
    }
    if (film_.complex != plain_) {
      const auto start = std::chrono::steady_clock::now();
      StepRecord record;
      advance(plain_, sides, record);
      finish(record, start);
    }
    return std::move(film_.inside);
  }

 private:
  std::shared_ptr<const PowerComplex> complex_of(std::vector<Vec3> sites, std::vector<double> weights) const {
    if (weights.empty() && sites.size() == points_.size()) return plain_;
    return std::make_shared<const PowerComplex>(std::move(sites), std::move(weights), options_.limits);
  }

  // The points, and the virtual sites that are inside the film still.
  std::shared_ptr<const PowerComplex> kept_sites(const std::vector<char>& sides, StepRecord& record) const {
    const std::vector<Vec3>& old = film_.complex->sites();
    std::vector<Vec3> sites = points_;
    for (std::size_t v = points_.size(); v < old.size(); ++v)
      if (sides[v] == kInsideFilm) sites.push_back(old[v]);
    record.virtual_left = static_cast<std::int64_t>(sites.size() - points_.size());
    return sites.size() == old.size() ? film_.complex : complex_of(std::move(sites), {});
  }

  // The points alone, with weights for those inside the film.
  std::shared_ptr<const PowerComplex> attracting(const std::vector<char>& sides, StepRecord& record) const {
    std::vector<Index> off;
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (sides[v] == kInsideFilm || sides[v] == 0) off.push_back(static_cast<Index>(v));
    record.weighted = static_cast<std::int64_t>(off.size());
    if (off.empty()) return plain_;
    return complex_of(points_, attraction_weights(film_surface(film_, points_.size()), points_, off));
  }

  // Returns the number of points on the film.
  std::size_t advance(std::shared_ptr<const PowerComplex> complex, std::vector<char>& sides,
                      StepRecord& record) {
    LabelledFilm next = film_step(film_, std::move(complex), spacing_, options_.memory, record.held);
    // A film that ran past all points, as where they are on a curve, is not taken; among the points alone it
    // starts again.
    if (std::count(next.inside.begin(), next.inside.end(), 1) > 0) {
      film_ = std::move(next);
    } else if (next.complex == plain_ || film_.complex == plain_) {
      film_ = first_;
    }
    return count(sides, record);
  }

  // Leaves the cavities of a film on plain_, unless that takes points off it. Returns the number on it.
  std::size_t leave_cavities(std::vector<char>& sides, StepRecord& record) {
    const std::int64_t before = record.attracted;
    const std::vector<char> with = film_.inside;
    const std::vector<char> cavity = cavities(mesh_, points_, spacing_, with, sides);
    for (std::size_t t = 0; t < cavity.size(); ++t)
      if (cavity[t]) film_.inside[t] = 0;
    if (const std::size_t on = count(sides, record); record.attracted >= before) return on;
    film_.inside = with;
    return count(sides, record);
  }

  std::size_t count(std::vector<char>& sides, StepRecord& record) const {
    sides = site_sides(film_);
    const auto end = sides.begin() + static_cast<std::ptrdiff_t>(points_.size());
    record.attracted = std::count(sides.begin(), end, kOnFilm);
    return static_cast<std::size_t>(record.attracted);
  }

  void finish(StepRecord& record, std::chrono::steady_clock::time_point start) const {
    record.round = options_.round;
    record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (options_.after_step) options_.after_step(record, film_);
  }

  const TetrahedralMesh& mesh_;
  const std::vector<Vec3>& points_;
  const std::vector<double>& spacing_;
  const FilmOptions& options_;
  const std::shared_ptr<const PowerComplex> plain_;  // of the points alone
  LabelledFilm film_, first_;                        // first_: the start, of the points alone
};

}  // namespace

std::vector<char> evolve_film(const std::function<bool(const Vec3&)>& contains, const TetrahedralMesh& mesh,
                              const std::vector<Vec3>& sites, const std::vector<double>& spacing,
                              const FilmOptions& options) {
  Evolution evolution(mesh, sites, spacing, options);
  evolution.start(contains);
  return evolution.run();
}

std::vector<char> evolve_film(std::vector<char> labels, const TetrahedralMesh& mesh,
                              const std::vector<Vec3>& sites, const std::vector<double>& spacing,
                              const FilmOptions& options) {
  Evolution evolution(mesh, sites, spacing, options);
  evolution.start(std::move(labels));
  return evolution.run();
}

}  // namespace filmsticking
