// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "geometry/work_limits.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// What a labelling of the tetrahedra as inside or outside costs, in units of area.
struct LabelCosts {
  const UnsetVector<std::array<float, 4>>& facet;  ///< [t][k]: to have facet k of t on the surface
  std::vector<double> hold;                        ///< [t]: > 0 to leave t outside; < 0 to have it inside
  std::vector<double> off;                         ///< [site]: to leave it off the surface
};

/// What was done to a labelling. On points that are dense beside the features of a closed surface it is next
/// to nothing; thin walls, noise and gaps are what it is for.
struct LabelCounts {
  /// Torn-off pieces of either label that were given up: chance clusters of tetrahedra. Fewer than pieces.
  std::int64_t islands = 0;
  /// Sites where the surface was not a disc at first: the cut weighs facets, not sites. At most all.
  std::int64_t singular = 0;
  /// Moves that lowered the number of surplus pieces around sites, and so no more than there were of these.
  std::int64_t repairs = 0;
  /// Moves that only took from the inside, where none lowered it: the last resort, which opens a part of a
  /// thin wall. Each takes a tetrahedron at least.
  std::int64_t erosions = 0;
  /// Tetrahedra relabelled towards `aim`: each leaves one difference from it less.
  std::int64_t warped = 0;
  /// Plugs, caps and discs that left fewer handles. With the tears they are no more than the handles and the
  /// pieces that went, as none is taken that adds any of either.
  std::int64_t tunnels = 0;
  /// Plugs, caps and ways, and bars taken away, that left fewer pieces: no more than pieces went, as none
  /// adds any.
  std::int64_t tears = 0;
  /// Folds and pinches that went: no more than eight for each flat tetrahedron.
  std::int64_t unfolded = 0;
  /// Moves that brought single sites on to the surface, which the cut left off as cheaper: a site that sticks
  /// out or lies in a dent of chance. No site more than eight times.
  std::int64_t reached = 0;
  /// Sites around which all was taken from the inside, after too many visits: none for the labels of a
  /// surface.
  std::int64_t stripped = 0;
  /// Of tetrahedra, in stars and around edges.
  std::int64_t visits = 0;
};

/// Relabels tetrahedra so that the surface between inside and outside is a 2-manifold, room by room.
///
/// Guarantees, whatever the labels and costs:
///  - the surface is closed and a manifold. It is one exactly if at every site those tetrahedra of its star
///    that are inside are one piece, joined by facets at the site, and those outside are one piece: the two
///    parts of a sphere around the site are discs then, and an edge with more than two facets would split one
///    of them. So all there is to keep is local;
///  - it does not cut itself, being part of a triangulation of space, but where tetrahedra are flat;
///  - it ends: the repair lowers the number of surplus pieces or else takes from the inside; the warp lowers
///    the number of differences, unfolding takes a few turns; the reach lowers the cost; each plug is tried
///    at most once for each radius;
///  - the work is bounded: after 10,000 visits of tetrahedra for each site, far more than a surface takes,
///  all
///    that is optional is left out, and what is inside is taken away around the sites that are singular
///    still.
class ManifoldLabels {
 public:
  /// `inside` is read and relabelled in place; infinite tetrahedra must be outside and stay there.
  ManifoldLabels(const TetrahedralMesh& mesh, const SiteGeometry& geometry, const LabelCosts& costs,
                 std::vector<char>& inside, const Cancel& cancel = {});

  /// Makes the surface a manifold, but for sites marked `exempt`. The others need that it is one, or leave it
  /// as it is.
  void repair(std::vector<char> exempt = {});

  /// Goes towards the labels `aim` as far as it can without a change of topology: each step relabels one
  /// tetrahedron and leaves a manifold of the same Euler characteristic, as homotopic deformation does in
  /// digital topology (Kong and Rosenfeld 1989). So it takes the sites that `aim` holds and leaves its
  /// handles and islands.
  void warp(const std::vector<char>& aim);

  /// Relabels flat tetrahedra of which the surface has facets on both sides, where it folds back on itself,
  /// and those with a facet of it on one side and a site of it that lies in that facet on the other, where it
  /// is pinched, as far as that is without a change of topology. A site that only a fold holds is off then,
  /// and one that was pinched belongs to the sheet that it lies in.
  void unfold();

  /// Brings sites off the surface on to it where relabelling one or two tetrahedra at the site does it, keeps
  /// the topology, makes no fold and costs less than the site is worth (sculpting by Boissonnat 1984, in both
  /// directions).
  void reach();

  /// Mends what chance and noise have broken, where that costs less than it is worth: where samples are
  /// random, both sides of a thin wall have a gap at the same place now and then, which leaves a tunnel that
  /// no samples line; a wall thinner than the spacing may be torn all along a valley, and a thin limb across;
  /// and noise builds bridges between sides that are near. What is tried: plugs, connected parts of what is
  /// outside and as narrow as a gap; what lies on caps, connected facets that are, where both sides are wide;
  /// the shortest ways from shards, thinner than any part that samples resolve, to other pieces; and discs
  /// across tunnels and bridges. One is taken if it leaves fewer handles or fewer pieces, and not more of
  /// either. `sites` are the corners of the tetrahedra.
  void fill_gaps(const std::vector<Vec3>& sites);

  /// The first of it: by plugs alone. Takes about a sixth of the time of all of it.
  void fill_plugs();

  /// Takes away what bars the way into a cavity, where that costs less than a piece less is worth: in a mouth
  /// of a few spacings all that is outside may be as narrow as a gap in one place. What is tried is connected
  /// parts of the inside, as wide as a mouth and no wall, between two pieces of the outside.
  void open_cavities(const std::vector<Vec3>& sites);

  const LabelCounts& counts() const { return counts_; }

 private:
  // A star in pieces: those parts of it that are inside and outside, each connected through facets at the
  // site.
  struct Census {
    int inside = 0, outside = 0;
    int surplus() const { return std::max(0, inside - 1) + std::max(0, outside - 1); }
    int sheets() const { return inside + outside - 1; }  // of the surface, at the site
    bool off() const { return inside == 0 || outside == 0; }
    bool plain() const { return surplus() == 0; }  // a disc, or no surface
  };
  using Move = std::vector<Index>;  // tetrahedra that change sides
  struct Effect {
    int surplus = 0;
    int euler = 0;  // of the surface with its sheets at singular places taken apart; -2: one handle more
    double cost = 0;
  };
  // What a plug is worth by what it leaves less of, and what each of its tetrahedra costs, in sites off the
  // surface; whether what lies around it may follow, without a change of topology, before that is compared;
  // and how far a change of pieces is looked for.
  struct Terms {
    double tunnel, tear, size = 0;
    bool relax = false;
    std::size_t look = std::numeric_limits<std::size_t>::max();
  };

  // What filling a tunnel is worth, in sites off the surface. A plug has two caps, which the votes are
  // against where the tunnel is real, and takes a wall away, which they are for then: that costs more.
  static constexpr double kTunnelWorth = 3;
  // What a piece less is worth. Two parts may lie close to each other, so this is little: in a tear the votes
  // are for a plug, or hardly against it.
  static constexpr double kTearWorth = 0.5;

  int corner(Index t, Index v) const {
    const auto& c = mesh_.tets.corners[t];
    return c[0] == v ? 0 : c[1] == v ? 1 : c[2] == v ? 2 : 3;
  }
  template <class Visit>
  void around_edge(Index t, int a, int b, const Visit& visit);
  bool mixed(Index t, int a, int b);
  Census census(Index v);
  Census census_of_flip(Index v, Index t, const Census& before);
  Census census_after(Index v, const Move& move);
  bool quick_census(Index v, Census& result) const;
  std::vector<Index> take_census();
  template <class Visit>
  void each_concerned(const Move& move, const std::vector<Census>& before, const Visit& visit);
  bool singular(Index v) const { return census_[v].surplus() > 0 && !exempt_[v]; }
  bool allowed(const Move& move) const;
  bool grows(const Move& move) const;
  double flip_cost(Index t) const;
  double least_cost(const Move& move, double piece);
  Effect effect(const Move& move);
  const std::vector<Index>& sites_of(const Move& move);
  std::vector<Census> apply(const Move& move, std::vector<Index>& singular);
  Move bridge(Index v, const std::vector<Index>& star, std::size_t begin, std::size_t end);
  std::vector<Move> moves_at(Index v, bool erode);
  Move best_move(Index v, bool erode);
  bool folded(Index t) const;
  int folds_around(const Move& move) const;
  int more_folds(const Move& move);
  Index pinch(Index t) const;
  Move best_unfold(Index t);
  Move best_reach(Index v, double share);
  void lower(std::vector<Index> singular, bool erode);
  bool spent() const;
  void strip();
  bool narrow(Index t, double radius) const;
  bool narrow_facet(const std::vector<Vec3>& sites, Index t, int k, double radius) const;
  static std::vector<Move> smallest_first(std::vector<Move> parts);
  std::vector<Move> plugs(double radius, double earlier) const;
  std::vector<Move> bars(const std::vector<Vec3>& sites, double radius);
  std::vector<Index> narrow_facets(const std::vector<Vec3>& sites, double radius) const;
  std::vector<std::vector<Index>> closing_parts(const std::vector<Index>& facets);
  bool dent(const Move& side, const std::vector<Index>& cap);
  std::vector<Move> caps(const std::vector<Vec3>& sites, double radius);
  std::vector<char> shards(const std::vector<Vec3>& sites, char label);
  std::vector<Move> ways(const std::vector<Vec3>& sites, double radius, char label);
  std::vector<Move> threads(const std::vector<char>& aim, char label);
  std::vector<Move> parts_changed(const std::vector<char>& before) const;
  double lining(const std::vector<Vec3>& sites, const Move& disc) const;
  struct Disc {
    Move part;
    double lining;
  };
  std::vector<Disc> discs(const std::vector<Vec3>& sites, double radius, char label);
  bool parted(const Move& part, char label, std::size_t most);
  Index piece(Index t);
  int pieces_around(const Move& part);
  void unite_around(const Move& part);
  void fill(const Move& plug, const Terms& terms);
  void fill_all(const std::vector<Move>& plugs, char label, const Terms& terms);
  std::int64_t name_pieces();
  std::int64_t handles() const;
  double roughness(const std::vector<Vec3>& sites) const;

  const TetrahedralMesh& mesh_;
  const SiteGeometry& geometry_;
  const LabelCosts& costs_;
  const Cancel cancel_;
  std::vector<char>& inside_;
  LabelCounts counts_;
  double site_cost_ = 0;     // the mean of costs_.off
  std::vector<Index> seed_;  // a tetrahedron at each site
  std::vector<Census> census_;
  std::vector<char> exempt_;  // [site]: need not be repaired
  // Of the last census: the star, piece by piece, and where each piece starts in it, and the end.
  std::vector<Index> star_;
  std::vector<std::size_t> first_;
  // Scratch.
  std::vector<std::uint32_t> seen_;
  std::uint32_t stamp_ = 0;
  std::vector<Index> waiting_, touched_, stuck_, source_;
  // While gaps are filled, [tetrahedron]: a name of its piece; and [name]: another of the same piece, or
  // itself.
  std::vector<Index> piece_, alias_;
  std::int64_t pieces_ = 0;  // at the last naming
};

// Calls visit(u) for the tetrahedra around the edge of t between its corners a and b, other than t, until it
// says false. Ends: the tetrahedra around an edge form a ring.
template <class Visit>
void ManifoldLabels::around_edge(Index t, int a, int b, const Visit& visit) {
  const auto& corners = mesh_.tets.corners[t];
  const Index v = corners[a], w = corners[b];
  int leave = 0;
  while (leave == a || leave == b) ++leave;
  Index last = corners[6 - a - b - leave];  // the corner that the next tetrahedron shares beside v and w
  for (Index u = mesh_.tets.neighbours[t][leave]; u != t && visit(u);) {
    ++counts_.visits;
    const auto& c = mesh_.tets.corners[u];
    const int out = corner(u, last);
    for (const Index x : c)
      if (x != v && x != w && x != c[out]) last = x;
    u = mesh_.tets.neighbours[u][out];
  }
}

/// Sorts, and leaves one of each.
inline void unique_sorted(std::vector<Index>& v) {
  std::sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
}

}  // namespace filmsticking
