// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "cutter.h"
#include "film/film.h"

namespace filmsticking {

/// Method::Film, the paper's: a film evolves from a surface around the points (section 4), then rounds of
/// field, cut and film remove what dangles (section 5).
class FilmMethod {
 public:
  /// All arguments must outlive it; the cutter has its tetrahedra.
  FilmMethod(Cutter& cutter, const SiteSet& sites, const SiteGeometry& geometry, const Options& options,
             Monitor& monitor, Report& report);

  /// Once only. Throws Cancelled.
  Candidate run();

 private:
  std::vector<std::function<Surface()>> first_films() const;
  FilmOptions film_options();
  Candidate film_from_outside();
  Candidate without_dangling(const Candidate& film);
  Candidate after_last_step(Candidate candidate);
  std::vector<double> winding_belief(const Surface& film) const;

  Cutter& cutter_;
  const SiteSet& sites_;
  const SiteGeometry& geometry_;
  const Options& options_;
  Monitor& monitor_;
  Report& report_;
};

}  // namespace filmsticking
