// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/unfold.h"

#include <array>
#include <cstddef>

#include "labelling/folds.h"

namespace filmsticking {
namespace {

// A fold less may be a pinch more, and the reverse; few last longer than this.
constexpr int kUnfoldTurns = 8;

// The site of a flat tetrahedron that lies in its facet opposite, if of its facets that one alone is on the
// surface, and the site is on it as well: before the sites were perturbed, the surface touched itself there.
// Else kNone.
Index pinch(const Labelling& labelling, Index t) {
  const int side = labelling.mesh().flat[t];
  int largest = 0;
  while (largest < 4 && side != 1 << largest) ++largest;
  if (largest == 4) return kNone;  // none is as large as the others together
  for (int k = 0; k < 4; ++k)
    if ((labelling.label(labelling.neighbours(t)[k]) != labelling.label(t)) != (k == largest)) return kNone;
  const Index v = labelling.corners(t)[largest];
  return labelling.census(v).off() ? kNone : v;
}

// The corners of the diagonal of a flat quadrilateral that crosses the surface there, if two facets of it
// that share the other diagonal are on the surface, and the edge between these corners is as well: before the
// sites were perturbed, both sheets touched. Else the same corner twice.
std::array<int, 2> crossing(Labelling& labelling, Index t) {
  const int side = labelling.mesh().flat[t];
  int met = 0;
  for (int k = 0; k < 4; ++k)
    if (labelling.label(labelling.neighbours(t)[k]) != labelling.label(t)) met |= 1 << k;
  if (side == 0 || (met != side && met != 15 - side)) return {0, 0};
  std::array<int, 2> ends{0, 0};
  int count = 0;
  for (int k = 0; k < 4; ++k)
    if ((met >> k & 1) != 0 && count++ < 2) ends[count - 1] = k;
  if (count != 2 || !labelling.mixed(t, ends[0], ends[1])) return {0, 0};
  return ends;
}

// What gives one sheet of a crossing another edge: of the tetrahedra around the diagonal a, b those that lie
// on the other side; or with `own` those on the side of t around the other diagonal.
Move around_diagonal(Labelling& labelling, Index t, int a, int b, bool own) {
  Move move;
  if (own) {
    move.push_back(t);
    int c = 0;
    while (c == a || c == b) ++c;
    b = 6 - a - b - c, a = c;
  }
  labelling.around_edge(t, a, b, [&](Index u) {
    if ((labelling.label(u) == labelling.label(t)) == own) move.push_back(u);
    return true;
  });
  return move;
}

// The move that removes a fold, a pinch or a crossing at a flat tetrahedron: it changes labels, and at a
// pinch so does what joins the site to the other sheet.
Move best_unfold(Labelling& labelling, Index t) {
  const auto helps = [&](const Move& move, int folds) {
    if (!labelling.allowed(move) || !labelling.grows(move) || more_folds(labelling, move) >= folds)
      return false;
    const Effect e = labelling.effect(move);
    return e.surplus == 0 && e.euler == 0 && (folds <= 0 || e.cost < labelling.site_cost());
  };
  Move move{t};
  if (folded(labelling, t)) return helps(move, 0) ? move : Move{};
  if (const auto [a, b] = crossing(labelling, t); a != b) {
    for (const bool own : {false, true}) {
      const Move around = around_diagonal(labelling, t, a, b, own);
      if (helps(around, 2)) return around;
    }
    return {};
  }
  const Index v = pinch(labelling, t);
  if (v == kNone) return {};
  labelling.search_star(v);
  for (Index u : labelling.star())
    if (labelling.label(u) != labelling.label(t)) move.push_back(u);
  return helps(move, 2) ? move : Move{};
}

}  // namespace

void unfold(Labelling& labelling) {
  const TetrahedralMesh& mesh = labelling.mesh();
  std::vector<Index> flat;
  for (std::size_t t = 0; t < mesh.size(); ++t)
    if (mesh.flat[t]) flat.push_back(static_cast<Index>(t));
  bool moved = true;
  for (int turn = 0; moved && turn < kUnfoldTurns; ++turn) {
    moved = false;
    for (Index t : flat) {
      if (labelling.spent()) return;
      const Move move = best_unfold(labelling, t);
      if (move.empty()) continue;
      labelling.apply(move);
      ++labelling.counts.unfolded;
      moved = true;
    }
  }
}

}  // namespace filmsticking
