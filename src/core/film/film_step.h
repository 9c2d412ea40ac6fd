// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "film/power_complex.h"
#include "geometry/surface.h"

namespace filmsticking {

/// A film: the boundary between the tetrahedra labelled inside and the others. It is closed by construction,
/// and part of a triangulation of space, so that it cuts itself at most at flat tetrahedra.
struct LabelledFilm {
  std::shared_ptr<const PowerComplex> complex;
  std::vector<char> inside;  ///< [tetrahedron]: 1 inside

  bool contains(const Vec3& x, Index near) const { return inside[complex->locate(x, near)] != 0; }
};

/// Where the tetrahedra of a site lie: bits, 1 inside and 2 outside; flat ones inside do not count. A site
/// with both is on the film; one without any is hidden.
std::vector<char> site_sides(const LabelledFilm& film);
constexpr char kInsideFilm = 1, kOutsideFilm = 2, kOnFilm = kInsideFilm | kOutsideFilm;

/// The film that a first surface gives: inside is a tetrahedron whose orthocentre the surface contains.
LabelledFilm film_within(const std::function<bool(const Vec3&)>& contains,
                         std::shared_ptr<const PowerComplex> complex);

/// One film step (paper, section 4), as a labelling: **a tetrahedron is inside the new film if its
/// orthocentre is inside the old one.** Its facet is on the new film if the ends of the dual power edge are
/// on different sides of the old film. The paper takes the facet if the edge crosses the film; both agree
/// where it crosses once. Where it crosses twice, as at a dangling plate, the facet is not on the film.
///
/// `complex`: of the next weights and virtual sites; may be that of `film`. `spacing`: of the points, which
/// are the first sites of both. `held`: receives the number of tetrahedra that keep their label.
///
/// With `memory` (the paper's smoothness rule, section 4.4) the film keeps what it has reached: a tetrahedron
/// with a corner on the old film stays inside if all its facets are narrower than kHeldWidth. Without this
/// rule a film digs into walls and the two sides of thin plates give way to each other.
LabelledFilm film_step(const LabelledFilm& film, std::shared_ptr<const PowerComplex> complex,
                       const std::vector<double>& spacing, bool memory, std::int64_t& held);

/// Circumradius of a facet below which memory holds, in the largest spacing of the tetrahedron's corners.
/// Twice the width at which a film enters (kRoomWidth): at a thin plate the sites of both sides count in the
/// spacing, which is a factor of 1.4, and chance makes wide gaps. Halved, the benchmark's hyperboloid has 1.5
/// times the Chamfer distance; doubled, 2.1 times.
constexpr double kHeldWidth = 4;

/// The film's facets, closed. A site at which the film touches itself has a vertex for each of its sheets, at
/// the same place, so this is a manifold unless a sheet touches itself along two edges. `points`: their
/// number; other sites are virtual, and their vertices have the site kNone.
Surface film_surface(const LabelledFilm& film, std::size_t points);

/// The same of labels of tetrahedra of sites that are all points.
Surface film_surface(const Tetrahedra& tets, const std::vector<char>& inside, const std::vector<Vec3>& sites);

}  // namespace filmsticking
