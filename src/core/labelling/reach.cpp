// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/reach.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "labelling/folds.h"

namespace filmsticking {
namespace {

// The share of its worth that a site may cost at first; it doubles when no site is left at that price. Cheap
// sites come first, as they often make others cheap.
constexpr double kFirstShare = 0.1;

// A site that was reached so often, and given up for others, stays off. So reach() ends whatever rounding
// does to the costs.
constexpr char kMostReaches = 8;

// The cheapest move that takes v onto the surface for less than this share of its worth.
Move best_reach(Labelling& labelling, Index v, double share) {
  Move best;
  double best_cost = -(1 - share) * labelling.costs().off[v];
  const auto consider = [&](Move move) {
    if (!labelling.allowed(move) || !labelling.grows(move) || labelling.least_cost(move, 0) >= best_cost)
      return;
    const Effect e = labelling.effect(move);
    if (e.surplus != 0 || e.euler != 0 || e.cost >= best_cost || more_folds(labelling, move) > 0) return;
    best_cost = e.cost, best = std::move(move);
  };
  labelling.search_star(v);
  const std::vector<Index> star = labelling.star();
  for (Index t : star) {
    if (labelling.spent()) return {};
    consider({t});
    const int own = labelling.corner(t, v);
    for (int k = 0; k < 4; ++k)
      if (const Index u = labelling.neighbours(t)[k]; k != own && u > t) consider({t, u});
  }
  return best;
}

}  // namespace

void reach(Labelling& labelling) {
  std::vector<char> changed(labelling.sites());  // something in its star, since it was looked at in vain
  std::vector<char> reaches(labelling.sites(), 0);
  for (double share = kFirstShare;;) {
    std::fill(changed.begin(), changed.end(), 1);
    for (bool moved = true; moved;) {
      moved = false;
      for (std::size_t s = 0; s < labelling.sites(); ++s) {
        if (labelling.spent()) return;
        const Index v = static_cast<Index>(s);
        if (!labelling.has_star(v) || !changed[v] || !labelling.census(v).off() || reaches[v] == kMostReaches)
          continue;
        changed[v] = 0;
        const Move move = best_reach(labelling, v, share);
        if (move.empty()) continue;
        const std::vector<Census> before = labelling.apply(move);
        ++labelling.counts.reached, ++reaches[v];
        moved = true;
        labelling.each_concerned(move, before, [&](Index t) {
          for (Index w : labelling.corners(t))
            if (w != kNone) changed[w] = 1;
        });
      }
    }
    if (share == 1) break;
    share = std::min(1.0, 2 * share);
  }
}

}  // namespace filmsticking
