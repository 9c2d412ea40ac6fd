// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "film/film_step.h"
#include "filmsticking/options.h"
#include "filmsticking/report.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// Options of evolve_film().
struct FilmOptions {
  /// Virtual sites, as in Options::virtual_sites. They are there from the first step, inside the film.
  int virtual_sites = 0;
  bool weights = true;  ///< attract what a stalled film leaves off: cavities(), weights (paper, section 4.2)
  bool memory = true;   ///< as in film_step()
  int max_steps = 60;
  int round = 0;                                                           ///< copied to every record
  TriangulationLimits limits;                                              ///< of each step's triangulation
  std::function<void(const StepRecord&, const LabelledFilm&)> after_step;  ///< optional
};

/// The entry of film/: evolves a film by film steps. Returns the labels of `mesh`, the Delaunay tetrahedra of
/// `sites`; none inside if the film passes through the points. `spacing`: per site.
///
/// The first film is what `contains` says. Virtual sites that a step takes onto the film leave, and those
/// outside it (paper, section 4.3). Where the film stalls, the rest leave, and so do cavities() that it did
/// not reach. Where it stalls again, the sites inside it get weights: the squares of their distances from it
/// (section 4.2). It ends where weights stall, too, or after max_steps; the last step has neither weights nor
/// virtual sites. Throws TooManyTetrahedra and Cancelled.
std::vector<char> evolve_film(const std::function<bool(const Vec3&)>& contains, const TetrahedralMesh& mesh,
                              const std::vector<Vec3>& sites, const std::vector<double>& spacing,
                              const FilmOptions& options);

/// The same from labels of the mesh instead of a first surface, with no virtual sites.
std::vector<char> evolve_film(std::vector<char> labels, const TetrahedralMesh& mesh,
                              const std::vector<Vec3>& sites, const std::vector<double>& spacing,
                              const FilmOptions& options);

}  // namespace filmsticking
