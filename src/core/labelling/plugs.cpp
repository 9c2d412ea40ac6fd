// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/plugs.h"

#include <cstddef>
#include <utility>

#include "labelling/narrow.h"

namespace filmsticking {
namespace {

// A larger plug fills no chance gap.
constexpr std::size_t kLargestPlug = 3000;

}  // namespace

std::vector<Move> plugs(const Labelling& labelling, double radius, double earlier) {
  const std::size_t n = labelling.mesh().size();
  const auto small = [&](Index t) { return !labelling.label(t) && narrow(labelling, t, radius); };
  std::vector<char> met(n, 0);
  std::vector<Move> parts;
  for (std::size_t s = 0; s < n; ++s) {
    if (met[s] || !small(static_cast<Index>(s))) continue;
    met[s] = 1;
    Move part{static_cast<Index>(s)};
    std::size_t beside_outside = 0;
    bool had = true;
    for (std::size_t i = 0; i < part.size(); ++i) {
      had = had && narrow(labelling, part[i], earlier);
      for (Index u : labelling.neighbours(part[i])) {
        if (met[u]) continue;
        if (small(u)) {
          met[u] = 1, part.push_back(u);
        } else {
          beside_outside += !labelling.label(u);
        }
      }
    }
    // A plug has two lids.
    if (!had && beside_outside >= 2 && part.size() <= kLargestPlug) parts.push_back(std::move(part));
  }
  return smallest_first(std::move(parts));
}

}  // namespace filmsticking
