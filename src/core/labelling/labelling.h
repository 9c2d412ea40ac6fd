// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "geometry/work_limits.h"
#include "labelling/marks.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// What a labelling of the tetrahedra as inside or outside costs, in units of area.
struct LabelCosts {
  const UnsetVector<std::array<float, 4>>& facet;  ///< [t][k]: of facet k of t, if it is on the surface
  std::vector<double> hold;                        ///< [t]: > 0: of t outside; < 0: its negative, of t inside
  std::vector<double> off;                         ///< [site]: of the site, if it is off the surface
};

/// What the functions on a labelling did. On points that are dense beside the features of a closed surface it
/// is next to nothing; thin walls, noise and gaps raise it.
struct LabelCounts {
  std::int64_t islands = 0;   ///< Pieces of either label that took the other one. Fewer than pieces.
  std::int64_t singular = 0;  ///< Sites that the repair found singular. At most all.
  std::int64_t repairs = 0;   ///< Moves that lowered the number of surplus pieces. At most as many as these.
  std::int64_t erosions = 0;  ///< Moves that only took from the inside, as none lowered that number.
  std::int64_t warped = 0;    ///< Tetrahedra that took the label of the aim. Each leaves one difference less.
  /// Mends that left fewer handles. With the tears no more than the handles and pieces that went.
  std::int64_t tunnels = 0;
  std::int64_t tears = 0;     ///< Mends that left fewer pieces. No more than the pieces that went.
  std::int64_t unfolded = 0;  ///< Folds and pinches that went. At most eight for each flat tetrahedron.
  std::int64_t reached = 0;   ///< Moves that took a site onto the surface. At most eight for each site.
  std::int64_t stripped = 0;  ///< Sites whose stars lost all of the inside, as the visits were spent.
  std::int64_t visits = 0;    ///< Of tetrahedra, in stars and around edges: the measure of all work.
};

/// Tetrahedra that change labels together.
using Move = std::vector<Index>;

/// The pieces of a site's star: sets of tetrahedra of one label that are connected through facets at the
/// site.
struct Census {
  int inside = 0, outside = 0;

  int surplus() const { return std::max(0, inside - 1) + std::max(0, outside - 1); }
  int sheets() const { return inside + outside - 1; }       ///< Of the surface, at the site.
  bool off() const { return inside == 0 || outside == 0; }  ///< The site is not on the surface.
  bool plain() const { return surplus() == 0; }             ///< The surface is a disc there, or absent.
};

/// What a move would change.
struct Effect {
  int surplus = 0;  ///< Surplus pieces, over all sites.
  int euler = 0;  ///< Euler characteristic, with the sheets at singular sites taken apart. -2: a handle more.
  int off = 0;    ///< Sites that leave the surface, less those that join it.
  double cost = 0;  ///< Of facets, held labels and sites off the surface.
};

/// Labels of tetrahedra, 1 inside and 0 outside, with a census of every site; the state that repair(),
/// warp(), unfold(), reach() and mend() change, move by move.
///
/// The surface between the labels is closed. It is a 2-manifold exactly if every site has at most one piece
/// inside and one outside: both are discs then on a small sphere around the site, and an edge with more than
/// two facets would split one of them. So all that these functions must keep is local, and the census knows
/// it. The surface does not cut itself, being part of a triangulation of space, except at flat tetrahedra.
///
/// The functions end: repair() lowers the number of surplus pieces or takes from the inside, warp() lowers
/// the number of differences, unfold() takes a few turns, reach() lowers the cost, mend() tries each part
/// once for each radius. Their work is bounded: after 10,000 visits of tetrahedra for each site, far more
/// than a surface takes, they leave out all that is optional.
class Labelling {
 public:
  /// Reads and changes `labels` in place. All must outlive it; infinite tetrahedra never change. Has no
  /// census before take_census(), which repair() calls.
  Labelling(const TetrahedralMesh& mesh, const SiteGeometry& geometry, const LabelCosts& costs,
            std::vector<char>& labels, const Cancel& cancel = {});

  const TetrahedralMesh& mesh() const { return mesh_; }
  const SiteGeometry& geometry() const { return geometry_; }
  const LabelCosts& costs() const { return costs_; }
  const std::array<Index, 4>& corners(Index t) const { return mesh_.tets.corners[t]; }
  const std::array<Index, 4>& neighbours(Index t) const { return mesh_.tets.neighbours[t]; }
  bool infinite(Index t) const { return mesh_.tets.infinite(t); }
  std::size_t sites() const { return seed_.size(); }
  bool has_star(Index v) const { return seed_[v] != kNone; }
  double site_cost() const { return site_cost_; }  ///< The mean of costs().off.
  void stop_if_cancelled() const { cancel_(); }

  /// Which corner of t the site v is; the last one if none of the others.
  int corner(Index t, Index v) const {
    const auto& c = corners(t);
    return c[0] == v ? 0 : c[1] == v ? 1 : c[2] == v ? 2 : 3;
  }

  char label(Index t) const { return labels_[t]; }
  const std::vector<char>& labels() const { return labels_; }
  std::vector<char>& labels() { return labels_; }  ///< The census is out of date once they are changed.
  void flip(Index t) { labels_[t] = !labels_[t]; }

  /// Calls look() with the labels as a move would make them. The census stays as it is.
  template <class Look>
  auto as_if(const Move& move, const Look& look);

  /// Of a site, as the last take_census(), apply() or recount() left it.
  const Census& census(Index v) const { return census_[v]; }
  /// Of every site, anew. Returns the singular ones.
  std::vector<Index> take_census();
  /// Of the sites of some tetrahedra, anew. Returns these, sorted; valid until the next call on this object.
  const std::vector<Index>& recount(const Move& changed);

  /// Searches the star of v: its census by the labels as they are. The tetrahedra are in star() then, piece
  /// by piece, and pieces() holds where each piece starts, and the end.
  Census search_star(Index v);
  const std::vector<Index>& star() const { return star_; }
  const std::vector<std::size_t>& pieces() const { return first_; }

  /// Sites where the surface need not be a manifold. Empty: no change.
  void exempt(std::vector<char> sites);
  /// Where the surface is a manifold now, it must stay one.
  void exempt_no_more();
  bool singular(Index v) const { return census_[v].surplus() > 0 && !exempt_[v]; }

  /// A move of at least one tetrahedron, and of no infinite one?
  bool allowed(const Move& move) const;
  /// Is one of its tetrahedra beside the other label? Else it would start an island.
  bool grows(const Move& move) const;
  double flip_cost(Index t) const;
  /// A lower bound of what a move costs, with `piece` for each surplus piece, without a search of stars.
  double least_cost(const Move& move, double piece);
  /// Leaves the labels as they are. Throws Cancelled.
  Effect effect(const Move& move);
  /// Makes a move and adds the sites that are singular then to a list. Returns the censuses of sites_of(move)
  /// before it. Throws Cancelled.
  std::vector<Census> apply(const Move& move, std::vector<Index>* singular = nullptr);
  /// A move that was made, and what takes it back.
  struct Made {
    Effect effect;
    std::vector<Census> before;
  };
  /// As apply(), and says what that changed: each star is searched once only. Throws Cancelled.
  Made make(const Move& move, std::vector<Index>* singular = nullptr);
  /// Takes back the last move that was made, without a search.
  void unmake(const Move& move, const std::vector<Census>& before);
  /// The corners of a move's tetrahedra, sorted; valid until the next call on this object.
  const std::vector<Index>& sites_of(const Move& move);

  /// Calls visit(u) for the tetrahedra around the edge between corners a and b of t, other than t, until it
  /// says false.
  template <class Visit>
  void around_edge(Index t, int a, int b, const Visit& visit);
  /// Are there tetrahedra of both labels around an edge, apart from t?
  bool mixed(Index t, int a, int b);
  /// Calls visit(u) for all tetrahedra whose flip may have another effect since apply(move) returned
  /// `before`.
  template <class Visit>
  void each_concerned(const Move& move, const std::vector<Census>& before, const Visit& visit);

  /// The visits that a labelling may take are used up: only the repair goes on, by stripping.
  bool spent() const;

  /// All that apply() changes.
  struct Snapshot {
    std::vector<char> labels, exempt;
    std::vector<Census> census;
    LabelCounts counts;
  };
  Snapshot snapshot() const;
  void restore(Snapshot snapshot);  ///< The visits stay counted.

  LabelCounts counts;
  Marks marks;  ///< Of tetrahedra, for one search at a time. search_star() and what calls it use them.

 private:
  Census census_of_flip(Index v, Index t, const Census& before);
  Census census_after(Index v, const Move& move);
  bool quick_census(Index v, Census& result) const;

  const TetrahedralMesh& mesh_;
  const SiteGeometry& geometry_;
  const LabelCosts& costs_;
  const Cancel cancel_;
  std::vector<char>& labels_;
  double site_cost_ = 0;
  std::vector<Index> seed_;  // a tetrahedron at each site
  std::vector<Census> census_;
  std::vector<char> exempt_;
  std::vector<Index> star_;
  std::vector<std::size_t> first_;
  std::vector<Index> waiting_, touched_;  // scratch
};

template <class Look>
auto Labelling::as_if(const Move& move, const Look& look) {
  for (Index t : move) flip(t);
  const auto result = look();
  for (Index t : move) flip(t);
  return result;
}

// Ends: the tetrahedra around an edge form a ring.
template <class Visit>
void Labelling::around_edge(Index t, int a, int b, const Visit& visit) {
  const auto& at = corners(t);
  const Index v = at[a], w = at[b];
  int leave = 0;
  while (leave == a || leave == b) ++leave;
  Index last = at[6 - a - b - leave];  // the corner that the next tetrahedron shares beside v and w
  for (Index u = neighbours(t)[leave]; u != t && visit(u);) {
    ++counts.visits;
    const auto& c = corners(u);
    const int out = corner(u, last);
    for (const Index x : c)
      if (x != v && x != w && x != c[out]) last = x;
    u = neighbours(u)[out];
  }
}

// A flip depends on what shares an edge with it; where a site has come onto the surface or left it, or is
// singular, on all of the star.
template <class Visit>
void Labelling::each_concerned(const Move& move, const std::vector<Census>& before, const Visit& visit) {
  for (Index t : move) {
    visit(t);
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b) around_edge(t, a, b, [&](Index u) { return visit(u), true; });
  }
  const std::vector<Index> at = sites_of(move);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Index v = at[i];
    if (before[i].off() == census_[v].off() && before[i].plain() && census_[v].plain()) continue;
    search_star(v);
    for (Index u : star_) visit(u);
  }
}

/// Sorts, and keeps one of each.
inline void unique_sorted(std::vector<Index>& v) {
  std::sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
}

}  // namespace filmsticking
