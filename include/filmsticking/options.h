// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

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

/// Deprecated: the former name of Method and FilmStart in one. Removed in version 0.3.
enum class InitialSurface {
  Sphere,  ///< Method::Film from FilmStart::Sphere
  Wrap,    ///< Method::Film from FilmStart::Wrap
  Carve,   ///< what `Options::method` says
  Given,   ///< Method::Film from FilmStart::Given
};

/// How a film loses its dangling plates and its topology is corrected (paper, section 5). Either is a belief
/// for one cut of the tetrahedra; the film's normals decide which facets lie on the surface.
enum class FieldMethod {
  None,     ///< the film is the result
  Poisson,  ///< Poisson's equation on the tetrahedra, with the film's normals: the paper's choice
  Sculpt,   ///< the film's winding number: RD's choice
};

/// What gives way where a site would own several regions of the film (paper, section 4.4).
enum class RingChoice {
  Smooth,   ///< the rougher side; and the film keeps what it has reached: the paper's choice
  Nearest,  ///< the side that is farther from the site, without memory: RD (Wang et al. 2022)
};

/// All options. The defaults need no tuning; `paper()` and `rd()` choose published pipelines. Most callers
/// need `open_boundary`, `viewpoint`, `threads` and `max_memory`; the others compare methods.
struct Options {
  Method method = Method::Labelling;         ///< what makes the surface
  FilmStart film_start = FilmStart::Sphere;  ///< where a film starts
  FieldMethod field = FieldMethod::Sculpt;   ///< what corrects a film's topology
  RingChoice ring = RingChoice::Smooth;      ///< which region of several a site keeps
  /// The former way to choose `method` and `film_start`; wins over both unless it is Carve.
  InitialSurface initial_surface = InitialSurface::Carve;

  /// For `virtual_sites`: one per local scale.
  static constexpr int kAdaptiveVirtualSites = -1;

  /// Virtual sites (paper, section 4.3) of Method::Film: their number, 0 for none, or kAdaptiveVirtualSites.
  /// They are inside the film from the first step, and leave once it has reached them.
  int virtual_sites = kAdaptiveVirtualSites;

  /// Method::Film: attract sites off a stalled film by weights (restricted power diagram). False: Voronoi
  /// only.
  bool weights = true;

  /// Relabel tetrahedra beside the sites that are off the surface at the end, where that keeps its topology.
  bool insert_leftover = true;

  /// Allow a boundary: remove faces that no data support (see Result::gaps). The result is then a manifold
  /// with or without boundary, such as the visible surface of a scan from one side. A cloud sampled from all
  /// sides stays closed. The open components of a scan from one side show the same side to one viewpoint: the
  /// sensor of a depth image, else the side on which the largest component is convex.
  bool open_boundary = false;

  /// More than 0: the result may have a boundary, but rims whose diameter, that of the smallest ball around
  /// them, is at most this get a lid. In the unit of the points. A lid has no new vertices, and avoids other
  /// faces where it can. A rim stays open only where a lid would break the manifold or lie on the surface, or
  /// that is very long and tangled. Report::holes lists all rims.
  /// The diagonal of the points' box, or more: the result is closed, as without open_boundary.
  double max_hole = 0;

  /// Sensor position, in the unit and frame of the points. What lies between a point and its sensor is
  /// outside, what lies just behind the point is inside; an open result shows its front to the sensor. Sight
  /// that more than a tenth of its lines contradict is not used. Ignored unless the method is Labelling.
  std::optional<Point> viewpoint;

  /// False: `viewpoint` is a guess, as the sensor origin of a cloud that may have been moved. It is asked
  /// only where the points alone leave the surface unclear, and believed only if it is outside their hull.
  bool trust_viewpoint = true;

  /// Sensor position of each point, instead of `viewpoint`: as many as points; not finite: unknown.
  std::shared_ptr<const std::vector<Point>> viewpoints;

  /// The way in which a far sensor looks at all points, instead of `viewpoint`: (0, 0, -1) from above. Of any
  /// length but zero.
  std::optional<Point> view_direction;

  /// Keep outliers: points far from all others, on no surface. False: they are left out.
  bool keep_outliers = false;

  /// Flip edges of the finished surface so that they lie along sharp edges and the bends of curved parts.
  /// Vertices and topology stay, and no flip makes faces intersect. A noisy surface has few flips.
  bool sharp_edges = true;

  /// Fill Result::stability, a confidence per face, in about a tenth more time.
  bool stability = false;

  /// Most steps of a film, before the first field; at least 1.
  int max_steps = 60;

  /// Most rounds of field and cut of Method::Film, 0 or more. They end once a round improves nothing.
  int max_rounds = 6;

  /// Number of threads; 0: all of the machine. The result does not depend on it.
  int threads = 0;

  /// Most memory in bytes, without the caller's points; 0: no limit. A reconstruction that needs more ends
  /// with Status::OutOfMemory. The need is estimated beforehand, from above for Method::Labelling.
  std::int64_t max_memory = 0;

  /// A closed oriented 2-manifold, for FilmStart::Given.
  std::shared_ptr<const Mesh> guiding_surface;

  /// The paper's pipeline: sphere, 1000 virtual sites, weights, smooth rings, one Poisson round, a last step.
  /// docs/stages/film.md lists where it differs from the text.
  FILMSTICKING_EXPORT static Options paper();

  /// The paper's predecessor, RD (Wang et al. 2022): no virtual sites or weights, the nearest region, cycles
  /// of film and sculpting.
  FILMSTICKING_EXPORT static Options rd();
};

/// The method that the options ask for, by its present or its former name.
inline Method method_of(const Options& options) {
  return options.initial_surface == InitialSurface::Carve ? options.method : Method::Film;
}

/// May the result have a boundary?
inline bool may_be_open(const Options& options) { return options.open_boundary || options.max_hole > 0; }

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
