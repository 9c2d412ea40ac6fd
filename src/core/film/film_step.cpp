// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/film_step.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "geometry/parallel.h"
#include "geometry/triangle_circle.h"

namespace filmsticking {
namespace {

Index least_corner(const std::array<Index, 4>& corners) {
  return *std::min_element(corners.begin(), corners.end());
}

// The tetrahedron stays by memory, though its orthocentre is outside. `sides`: of the film before.
bool stays(const LabelledFilm& before, const std::vector<char>& sides, const PowerComplex& complex,
           std::size_t t, const std::vector<double>& spacing) {
  const auto& corners = complex.tetrahedra().corners[t];
  double scale = 0;
  Index reached = kNone;
  Vec3 centroid = Vec3::Zero();
  for (const Index v : corners) {
    centroid += complex.sites()[v] / 4;
    if (static_cast<std::size_t>(v) >= spacing.size()) continue;
    scale = std::max(scale, spacing[v]);
    if (sides[v] == kOnFilm) reached = v;
  }
  if (reached == kNone) return false;
  const double widest = kHeldWidth * scale;
  for (int k = 0; k < 4; ++k) {
    const auto& f = kFacet[k];
    const auto& sites = complex.sites();
    if (circumradius2(sites[corners[f[0]]], sites[corners[f[1]]], sites[corners[f[2]]]) >= widest * widest)
      return false;
  }
  return before.contains(centroid, reached);
}

/// The boundary facets, glued along their edges through the inside.
class Sheets {
 public:
  Sheets(const Tetrahedra& tets, const std::vector<char>& inside)
      : tets_(tets), inside_(inside), number_(4 * tets.size(), kNone) {
    for (std::size_t t = 0; t < tets.size(); ++t)
      for (int k = 0; inside[t] && k < 4; ++k)
        if (!inside[tets.neighbours[t][k]]) {
          number_[4 * t + static_cast<std::size_t>(k)] = static_cast<Index>(facets_.size());
          facets_.push_back(static_cast<Index>(4 * t) + k);
        }
  }

  // Triangles of vertices; `site`: receives the site of each. Corners of facets that meet along an edge are
  // one vertex.
  std::vector<Corners> triangles(std::vector<Index>& site) const {
    DisjointSets corners(3 * facets_.size());
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const Index t = facets_[f] / 4;
      const int k = facets_[f] % 4;
      for (int m = 0; m < 4; ++m) {
        if (m == k) continue;
        const Index other = across(t, k, m);
        for (int e = 0; e < 4; ++e)
          if (e != k && e != m)
            corners.unite(corner(static_cast<Index>(f), tets_.corners[t][e]),
                          corner(other, tets_.corners[t][e]));
      }
    }
    std::vector<Index> vertex;
    site.resize(static_cast<std::size_t>(corners.number(vertex)));
    std::vector<Corners> triangles(facets_.size());
    for (std::size_t f = 0; f < facets_.size(); ++f)
      for (int i = 0; i < 3; ++i) {
        triangles[f][i] = vertex[3 * f + static_cast<std::size_t>(i)];
        site[triangles[f][i]] = site_of(static_cast<Index>(f), i);
      }
    return triangles;
  }

 private:
  Index site_of(Index facet, int i) const {
    return tets_.corners[facets_[facet] / 4][kFacet[facets_[facet] % 4][i]];
  }
  Index corner(Index facet, Index s) const {
    int i = 0;
    while (i < 2 && site_of(facet, i) != s) ++i;
    return 3 * facet + i;
  }

  // The facet that the facet k of t meets at its edge opposite corner m, around the edge through the inside.
  // Ends: around an edge are finitely many tetrahedra, and the facet's other side is outside.
  Index across(Index t, int k, int m) const {
    Index pivot = tets_.corners[t][k];  // of the facet to leave through, the corner off the edge
    int leave = m;
    while (inside_[tets_.neighbours[t][leave]]) {
      const Index u = tets_.neighbours[t][leave];
      const auto &from = tets_.corners[t], &to = tets_.corners[u];
      const Index gone = from[leave];
      int fresh = 0, old = 0;
      for (int i = 0; i < 4; ++i) {
        if (to[i] == pivot) old = i;
        if (std::find(from.begin(), from.end(), to[i]) == from.end() || to[i] == gone) fresh = i;
      }
      pivot = to[fresh];
      leave = old;
      t = u;
    }
    return number_[4 * static_cast<std::size_t>(t) + static_cast<std::size_t>(leave)];
  }

  const Tetrahedra& tets_;
  const std::vector<char>& inside_;
  std::vector<Index> number_;  // [4 * tetrahedron + facet]: the number of the facet, or kNone
  std::vector<Index> facets_;  // 4 * tetrahedron + facet
};

}  // namespace

std::vector<char> site_sides(const LabelledFilm& film) {
  const PowerComplex& complex = *film.complex;
  std::vector<char> sides(complex.sites().size(), 0);
  for (std::size_t t = 0; t < complex.size(); ++t) {
    if (film.inside[t] && complex.flat(t)) continue;
    for (const Index v : complex.tetrahedra().corners[t])
      if (v != kNone) sides[v] = static_cast<char>(sides[v] | (film.inside[t] ? kInsideFilm : kOutsideFilm));
  }
  return sides;
}

LabelledFilm film_within(const std::function<bool(const Vec3&)>& contains,
                         std::shared_ptr<const PowerComplex> complex) {
  LabelledFilm film{std::move(complex), {}};
  film.inside.assign(film.complex->size(), 0);
  parallel_each(film.complex->size(), [&](std::size_t t) {
    if (!film.complex->tetrahedra().infinite(static_cast<Index>(t)))
      film.inside[t] = static_cast<char>(contains(film.complex->orthocentre(t)));
  });
  return film;
}

LabelledFilm film_step(const LabelledFilm& film, std::shared_ptr<const PowerComplex> complex,
                       const std::vector<double>& spacing, bool memory, std::int64_t& held) {
  LabelledFilm next{std::move(complex), {}};
  const PowerComplex& tetrahedra = *next.complex;
  next.inside.assign(tetrahedra.size(), 0);
  const UnsetVector<Index>* flow = next.complex == film.complex ? &tetrahedra.flow() : nullptr;
  parallel_each(tetrahedra.size(), [&](std::size_t t) {
    if (tetrahedra.tetrahedra().infinite(static_cast<Index>(t))) return;
    const Index near = least_corner(tetrahedra.tetrahedra().corners[t]);
    next.inside[t] = flow != nullptr ? film.inside[(*flow)[t]]
                                     : static_cast<char>(film.contains(tetrahedra.orthocentre(t), near));
  });
  std::vector<char> back(next.inside.size(), 0);
  const std::vector<char> sides = memory ? site_sides(film) : std::vector<char>();
  parallel_each(back.size(), [&](std::size_t t) {
    if (memory && !next.inside[t] && !tetrahedra.tetrahedra().infinite(static_cast<Index>(t)) &&
        !tetrahedra.flat(t))
      back[t] = static_cast<char>(stays(film, sides, tetrahedra, t, spacing));
  });
  held = std::count(back.begin(), back.end(), 1);
  for (std::size_t t = 0; t < back.size(); ++t)
    if (back[t]) next.inside[t] = 1;
  return next;
}

Surface film_surface(const LabelledFilm& film, std::size_t points) {
  Surface surface = film_surface(film.complex->tetrahedra(), film.inside, film.complex->sites());
  for (Index& s : surface.site)
    if (static_cast<std::size_t>(s) >= points) s = kNone;
  return surface;
}

Surface film_surface(const Tetrahedra& tets, const std::vector<char>& inside,
                     const std::vector<Vec3>& sites) {
  const Sheets sheets(tets, inside);
  Surface surface;
  surface.triangles = sheets.triangles(surface.site);
  for (const Index s : surface.site) surface.positions.push_back(sites[s]);
  return surface;
}

}  // namespace filmsticking
