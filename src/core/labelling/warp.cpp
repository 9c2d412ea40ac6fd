// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/warp.h"

#include <cstddef>

namespace filmsticking {

void warp(Labelling& labelling, const std::vector<char>& aim) {
  const auto differs = [&](Index t) { return labelling.label(t) != aim[t] && !labelling.infinite(t); };
  std::vector<Index> front, next;
  for (std::size_t t = 0; t < aim.size(); ++t)
    if (differs(static_cast<Index>(t))) front.push_back(static_cast<Index>(t));
  // Ends: every step leaves a difference from `aim` less, and what is looked at again is beside a step.
  while (!front.empty()) {
    unique_sorted(front);
    next.clear();
    for (Index t : front) {
      const Move move{t};
      if (labelling.label(t) == aim[t] || !labelling.grows(move)) continue;
      if (labelling.spent()) return;
      const Effect e = labelling.effect(move);
      if (e.surplus != 0 || e.euler != 0) continue;
      const std::vector<Census> before = labelling.apply(move);
      ++labelling.counts.warped;
      labelling.each_concerned(move, before, [&](Index u) {
        if (differs(u)) next.push_back(u);
      });
    }
    front.swap(next);
  }
}

}  // namespace filmsticking
