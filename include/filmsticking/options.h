// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "export.h"
#include "types.h"

namespace filmsticking {

/// What makes the surface.
enum class Method {
  Labelling,  ///< a minimum cut labels the Delaunay tetrahedra inside or outside; moves mend the labels
  Film,       ///< the paper's: a film steps from `Options::film_start` towards the points
};

/// The closed surface that a film starts from (paper, section 3).
enum class FilmStart {
  Sphere,  ///< the bounding sphere: the paper's choice
  Wrap,    ///< a coarse alpha wrap of the points (CGAL)
  Given,   ///< `Options::guiding_surface`
};

/// The former name of Method and FilmStart in one; goes with version 0.3.
enum class InitialSurface {
  Sphere,  ///< Method::Film from FilmStart::Sphere
  Wrap,    ///< Method::Film from FilmStart::Wrap
  Carve,   ///< what `Options::method` says
  Given,   ///< Method::Film from FilmStart::Given
};

/// How dangling plates are removed and the topology is corrected (paper, section 5).
enum class FieldMethod {
  None,     ///< the film is the result
  Poisson,  ///< Poisson's equation on the film's normals: the paper's choice
  Sculpt,   ///< winding number of the film, then a minimum cut through the Delaunay tetrahedra
};

/// Which ring of triangles a site keeps when it owns several regions of the film (paper, section 4.4).
enum class RingChoice {
  Smooth,   ///< the ring with the smallest variation of normals: the paper's choice
  Nearest,  ///< the ring of the region nearest to the site: RD (Wang et al. 2022)
};

/// Everything that can be chosen. The defaults need no tuning; `paper()` runs the paper's own pipeline.
struct Options {
  Method method = Method::Labelling;         ///< what makes the surface
  FilmStart film_start = FilmStart::Sphere;  ///< where a film starts
  FieldMethod field = FieldMethod::Sculpt;   ///< what corrects a film's topology
  RingChoice ring = RingChoice::Smooth;      ///< which region of several a site keeps
  /// The former way to choose `method` and `film_start`; wins over both unless it is Carve.
  InitialSurface initial_surface = InitialSurface::Carve;

  /// For `virtual_sites`: one per local scale.
  static constexpr int kAdaptiveVirtualSites = -1;

  /// Virtual sites (paper, section 4.3): how many (0: none), or kAdaptiveVirtualSites. They join when the
  /// film from a sphere, a wrap or a given surface stalls, where it has not reached; a carved film needs
  /// none.
  int virtual_sites = kAdaptiveVirtualSites;

  /// Attract stalled sites by weights (restricted power diagram); false: Voronoi only.
  bool weights = true;

  /// Bring on the sites that are still off: a carved surface by relabelling tetrahedra beside them, a film by
  /// splitting its nearest face where that is clean.
  bool insert_leftover = true;

  /// Leave out the faces that no data supports (see Result::gaps): the result is a manifold with boundary
  /// then, the visible surface of a scan from one side, say. A cloud from all sides stays closed. Pieces with
  /// a boundary face one viewpoint, where there is one: from its convex side.
  bool open_boundary = false;

  /// Where the points may have been seen from, in their own unit and frame: a sensor's place. A depth image
  /// (every point alone on its line of sight, apart from the others as pixels are) gives the surface that
  /// shows all its faces to its viewpoint if it is to be open, and else what is behind it. Mostly the points
  /// themselves say where that is; where they do not, as they are thinned or noisy, this is tried. Of points
  /// that cannot all be seen from there, or are as well understood without, and with another
  /// method than Labelling, it changes nothing.
  std::optional<Point> viewpoint;

  /// Bring on outliers, too: points far from all others that are no part of a surface. They are left off
  /// otherwise.
  bool keep_outliers = false;

  /// Flip edges of the finished surface where that lays them along the shape's sharp edges and the bends of
  /// its curved parts. Vertices, topology and what intersects stay as they are; a noisy surface stays nearly
  /// so.
  bool sharp_edges = true;

  /// Film steps allowed in one evolution of the film before the first field; at least 1.
  int max_steps = 60;

  /// Rounds of field and film, 0 or more; they end sooner when nothing gets better. A carved surface is not
  /// improved by them (measured) and has none.
  int max_rounds = 6;

  /// Threads; 0: all that the machine has. The result is the same for every number.
  int threads = 0;

  /// Bytes that a reconstruction may take, beside the points handed in; 0: no limit. What it needs is
  /// estimated (from above, for a carved surface) before it is taken; one that needs more ends with
  /// Status::OutOfMemory.
  std::int64_t max_memory = 0;

  /// A closed oriented 2-manifold, for FilmStart::Given.
  std::shared_ptr<const Mesh> guiding_surface;

  /// The paper's pipeline: sphere, 1000 virtual sites, weights, one Poisson round, nothing inserted, no edge
  /// flipped. One thing differs: the virtual sites join at the first stall, since from the start they pull
  /// the film through the shape.
  FILMSTICKING_EXPORT static Options paper();
};

/// The method that the options ask for, by its present or its former name.
inline Method method_of(const Options& options) {
  return options.initial_surface == InitialSurface::Carve ? options.method : Method::Film;
}

/// The surface that a film starts from, by its present or its former name.
inline FilmStart film_start_of(const Options& options) {
  switch (options.initial_surface) {
    case InitialSurface::Sphere:
      return FilmStart::Sphere;
    case InitialSurface::Wrap:
      return FilmStart::Wrap;
    case InitialSurface::Given:
      return FilmStart::Given;
    case InitialSurface::Carve:
      break;
  }
  return options.film_start;
}

}  // namespace filmsticking
