// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/energy.h"

#include <cmath>
#include <cstddef>

namespace filmsticking {

Effect energy_of(const Labelling& labelling) {
  Effect all;
  const LabelCosts& costs = labelling.costs();
  int facets = 0;
  for (std::size_t s = 0; s < labelling.mesh().size(); ++s) {
    const Index t = static_cast<Index>(s);
    const double hold = costs.hold[s];
    if (labelling.label(t) ? hold < 0 : hold > 0) all.cost += std::abs(hold);
    if (!labelling.label(t)) continue;
    for (int k = 0; k < 4; ++k)
      if (!labelling.label(labelling.neighbours(t)[k])) ++facets, all.cost += costs.facet[s][k];
  }
  // With all sheets apart the surface has three edges for two facets: V - E + F = V - F / 2.
  all.euler = -facets / 2;
  for (std::size_t v = 0; v < labelling.sites(); ++v) {
    if (!labelling.has_star(static_cast<Index>(v))) continue;
    const Census& census = labelling.census(static_cast<Index>(v));
    all.surplus += census.surplus();
    all.euler += census.sheets();
    if (census.off()) ++all.off, all.cost += costs.off[v];
  }
  return all;
}

}  // namespace filmsticking
